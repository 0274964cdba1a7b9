// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/misplaced.h"

#include "bind/blocks.h"
#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

struct MisplacedCase {
    const char* script;
    const char* complaint;
};

}  // namespace

TEST_CASE("what has no place in a block is reported once", "[reading]") {
    const auto [script, expected] = GENERATE(Catch::Generators::values<MisplacedCase>({
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
        {"anisotropy { 1, 2 }",
         "error not-implemented: `anisotropy` is not available in this version"},
        {"sphere { 0, 1 interior { anisotropy { 1 } } }",
         "error not-implemented: `anisotropy` is not available in this version"},
        {"sphere { 0, 1 finish { subsurface { translucency -1 } } }",
         "error out-of-range: `translucency` of `subsurface` must be at least 0 in each channel"},
        {"sphere { 0, 1 bounded_by { box { -1, 1 } } sturm }",
         "warning no-effect: `sturm` has no effect in this version"},
    }));
    CHECK(complaint(script) == expected);
}

TEST_CASE("words of blocks are known, those of what is not available are not", "[reading]") {
    for (const std::string_view word : {"sphere", "union", "warp", "ior", "fog", "tile2"})
        CHECK(block_table().knows(word));
    for (const std::string_view word : {"anisotropy", "importance", "nothing"})
        CHECK_FALSE(block_table().knows(word));
}

}  // namespace candelabra
