// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as an INI file that came with a scene: no crash, and a file that permits itself nothing.
#include "fuzz/target.h"
#include "options/options.h"

#include <cstdlib>
#include <vector>

using namespace candelabra;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    // A file that names itself is read a few times only: options_test shows that a thousand end.
    constexpr int most_reads = 3;
    int reads = 0;
    const Reader reader([&](const std::string& path) -> std::optional<std::string> {
        if (path != "stranger.ini" || ++reads > most_reads) return std::nullopt;
        return text;
    });
    const std::vector<std::string_view> named = {"stranger.ini"};
    Diagnostics diagnostics;
    const Options made = read_options(named, diagnostics, reader);
    if (diagnostics.error_count() == 0 &&
        (made.commands.allowed || !made.writable.empty() || !made.limits.within(Limits())))
        std::abort();
    return 0;
}
