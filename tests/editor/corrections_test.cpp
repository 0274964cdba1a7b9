// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/corrections.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("what a message asks for stands in place of the wrong word") {
    CHECK(correction("a scene has no word `shpere`\ndid you mean `sphere`?", "shpere") == "sphere");
    CHECK(correction("did you mean `#declare`?", "#define") == "#declare");
    CHECK(correction("did you mean `end`?", "#endif") == "#end");
    CHECK(correction("did you mean `colors.inc`?", "\"colours.inc\"") == "\"colors.inc\"");
    CHECK(correction("did you mean \"radiance\"?", "\"radiant\"") == "\"radiance\"");
    CHECK_FALSE(correction("a scene has no word `qqq`", "qqq"));
    CHECK_FALSE(correction("did you mean `a`?", "sphere { 0, 1 }"));
    CHECK_FALSE(correction("did you mean `a`?", ""));
    CHECK_FALSE(correction("did you mean to leave?", "word"));
    CHECK_FALSE(correction("did you mean `", "word"));
    CHECK_FALSE(correction("did you mean ``?", "word"));
}

}  // namespace candelabra
