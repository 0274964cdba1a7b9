// SPDX-License-Identifier: GPL-3.0-or-later
// Any lines as the words of a command line: no crash; and what was said without a mistake is said
// again by the lines that --create-ini would write.
#include "fuzz/target.h"
#include "options/ini.h"
#include "options/options.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

using namespace candelabra;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    std::vector<std::string_view> words;
    constexpr std::size_t most = 20;  // each wrong word is compared with all options
    for (std::string_view rest = text; !rest.empty() && words.size() < most;) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        words.push_back(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    Diagnostics diagnostics;
    const Options made = read_options(words, diagnostics);
    if (diagnostics.failed()) return 0;
    std::string lines;
    for (const auto& [row, each] : made.given) {
        // No line can say these.
        if (each.find('"') != each.npos && each.find('\'') != each.npos) return 0;
        lines += ini_line(each) + "\n";
    }
    const Reader reader([&](const std::string&) { return std::optional(lines); });
    Diagnostics others;
    const Options again = read_options({}, others, reader, "/home/own.ini");
    if (others.failed() ||
        !std::ranges::equal(again.given, made.given, {}, &GivenOption::line, &GivenOption::line))
        std::abort();
    return 0;
}
