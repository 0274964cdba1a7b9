// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/printable.h"

#include <catch2/catch.hpp>

#include <string_view>

namespace candelabra {

using namespace std::literals;

TEST_CASE("text is shown as it is unless it could act on the terminal") {
    struct Case {
        std::string_view text, shown;
    };
    const Case cases[] = {
        {"plain text, é€🙂", "plain text, é€🙂"},
        {"\x1b[31m", "␛[31m"},
        {"a\tb\nc\r", "a␉b␊c␍"},
        {"\0"sv, "␀"},
        {"\x7F", "␡"},
        {"\xE9t\xE9", "\uFFFDt\uFFFD"},
        {"a\u202Eb\u2066c", "a\uFFFDb\uFFFDc"},
        {"a\u200Bb\uFEFF", "a\uFFFDb\uFFFD"},
        {"\u0085\u009B", "\uFFFD\uFFFD"},
        {"\u00A0", "\u00A0"},
    };
    for (const Case& each : cases) CHECK(printable(each.text) == each.shown);
}

}  // namespace candelabra
