// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/block.h"

#include "support/script.h"

#include <catch2/catch.hpp>

namespace {

struct BlockCase {
    const char* script;
    const char* complaint;
};

}  // namespace

TEST_CASE("what has no place in a block is told of once", "[bind]") {
    const auto [script, expected] = GENERATE(values<BlockCase>({
        {"sphere { 0, 1 trnslate x scale 2 }",
         "error unknown-word: `sphere` has no word `trnslate`"},
        {"sphre { 0, 1 }", "error unknown-word: a scene has no word `sphre`"},
        {"sphere { Centre, 1 }", "error unknown-name: nothing is declared as `Centre`"},
        {"sphere { 0, 1 translate Offset }", "error unknown-name: nothing is declared as `Offset`"},
        {"#declare T = texture { } sphere { 0, 1 T }",
         "error misplaced: a texture has no place in `sphere`"},
        {"sphere { 0, 1 location 3 }", "error misplaced: `location` has no place in `sphere`"},
        {"finish { ambient 1 }", "error misplaced: `finish` has no place in a scene"},
        {"sphere { 0, 1 [1 2] }", "error misplaced: an entry in brackets has no place in `sphere`"},
        {"sphere { 0, 1 { } }",
         "error misplaced: braces without a word before them have no place in `sphere`"},
        {"finish", "error misplaced: `finish` has no place in a scene"},
        {"media { 1, 2 }", "error not-implemented: `media` is not available in this version"},
        {"sphere { 0, 1 interior { media { emission 1 } } }",
         "error not-implemented: `media` is not available in this version"},
        {"sphere { 0, 1 finish { subsurface { translucency -1 } } }",
         "error out-of-range: `translucency` of `subsurface` must be at least 0 in each channel"},
        {"sphere { 0, 1 bounded_by { box { -1, 1 } } sturm }",
         "warning no-effect: `sturm` has no effect in this version"},
    }));
    CHECK(complaint(script) == expected);
}

TEST_CASE("what follows from a hole is not told of", "[bind]") {
    CHECK(run("#version 3.7; sphere { Nothing, 1 }").said.size() == 1);
    CHECK(run("#version 3.7; #declare A = torus { 0, x } object { A translate x } union { A A }")
              .said.size() == 1);
    CHECK(run("#version 3.7; #declare T = texture { pigment { Nothing } } sphere { 0, 1 texture { "
              "T } }")
              .said.size() == 1);
}

TEST_CASE("a word without effect is told of at its first place only", "[bind]") {
    CHECK(run("#version 3.7; sphere { 0, 1 sturm } sphere { 0, 1 sturm }").said.size() == 1);
}
