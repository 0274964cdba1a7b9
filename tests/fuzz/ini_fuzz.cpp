// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as an INI file that came with a scene, and as the words of a command line: no crash,
// and a file that permits itself nothing.
#include "app/options.h"
#include "fuzz/target.h"

#include <cstdlib>
#include <vector>

using namespace candelabra;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const Reader reader([&](const std::string& path) -> std::optional<std::string> {
        if (path != "stranger.ini") return std::nullopt;
        return text;
    });
    const std::vector<std::string_view> named = {"stranger.ini"};
    Diagnostics diagnostics;
    const Options made = read_options(named, diagnostics, reader);
    if (diagnostics.error_count() == 0 &&
        (made.commands.allowed || !made.writable.empty() || !made.limits.within(Limits())))
        std::abort();
    std::vector<std::string_view> words;
    for (std::string_view rest = text; !rest.empty() && words.size() < 100;) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        words.push_back(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    Diagnostics others;
    read_options(words, others, reader);
    return 0;
}
