// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/knobs.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("documented names can be turned") {
    const auto found = knobs(
        "#ifndef (Height) #declare Height = 2; #end  // 0 to 5 by 0.5: how tall it is\n"
        "#ifndef (Turn)\n    #declare Turn = -30;\n#end // -180 to 180\n"
        "sphere { 0, Height }");
    REQUIRE(found.size() == 2);
    CHECK(found[0] == Knob{"Height", 2, 0, 5, 0.5, "how tall it is"});
    CHECK(found[1] == Knob{"Turn", -30, -180, 180, 3.6, ""});
}

TEST_CASE("what is not in the form is left alone") {
    for (const char* scene :
         {"#ifndef (A) #declare A = 2; #end", "#ifndef (A) #declare A = 2; #end // how tall",
          "#ifndef (A) #declare A = 2; #end\n// 0 to 5",
          "#ifdef (A) #declare A = 2; #end // 0 to 5", "#ifndef (A) #declare B = 2; #end // 0 to 5",
          "#ifndef (A) #declare A = 2*3; #end // 0 to 5",
          "#ifndef (A) #declare A = 2; #end // 5 to 0", "#ifndef (A) #declare A = 2; // 0 to 5",
          "#ifndef (A) #declare A = 2; #end // 0 to 5 by 0",
          "#ifndef (A) #declare A =", "#ifndef"}) {
        CAPTURE(scene);
        CHECK(knobs(scene).empty());
    }
}

}  // namespace candelabra
