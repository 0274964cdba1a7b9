// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/depfile.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a rule names all files once, as make reads them") {
    CHECK(depfile("a b.png", {{"s.pov", "1"}, {"x/$y#.inc", "2"}, {"s.pov", "3"}, {"-", "4"}}) ==
          "a\\ b.png: \\\n  s.pov \\\n  x/$$y\\#.inc\n");
}

TEST_CASE("the rule of --depfile is written beside the picture") {
    Shell shell;
    shell.write("part.inc", "#declare Size = 2;");
    shell.write("s.pov", "#include \"part.inc\"\n" + std::string(lit_scene));
    CHECK(shell({shell.path("s.pov"), "-V", "+W4", "+H4", "+O" + shell.path("a.png"), "--depfile",
                 shell.path("a.d")}) == 0);
    CHECK(shell.content("a.d") == shell.path("a.png") + ": \\\n  " + shell.path("s.pov") +
                                      " \\\n  " + shell.path("part.inc") + "\n");
}

}  // namespace candelabra
