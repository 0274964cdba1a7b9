// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/scene_text.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("what a scene says keeps its lines and tabs, and acts on no terminal", "[text]") {
    CHECK(printable_lines("a\tb\nc\n") == "a\tb\nc\n");
    CHECK(printable_lines("").empty());
    CHECK(printable_lines("\n\n") == "\n\n");
    // Sets the clipboard, the title and the colour of many terminals.
    CHECK(printable_lines("\x1b]52;c;cHduZWQ=\x07\n") == "␛]52;c;cHduZWQ=␇\n");
    CHECK(printable_lines("\x1b]0;title\x07") == "␛]0;title␇");
    CHECK(printable_lines("done\rfake") == "done␍fake");
    CHECK(printable_lines("\u009B31m\u202E\xFF") == "\uFFFD31m\uFFFD\uFFFD");
}

TEST_CASE("a name of any length makes a short message", "[text]") {
    CHECK(clipped("a.inc") == "a.inc");
    CHECK(clipped(std::string(400, 'x')).size() == 400);
    const std::string cut = clipped("begin" + std::string(2'000'000, 'x') + "end");
    CHECK(cut.size() < 400);
    CHECK(cut.starts_with("begin"));
    CHECK(cut.ends_with("end"));
}

}  // namespace candelabra
