// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/unbracketed_vector.h"

#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// The help of the first diagnostic; "nothing" if there is none.
std::string advice(const std::string& script) {
    const Script done = run("#version 3.7; #declare A = 2;\n" + script);
    return done.said.empty() ? "nothing" : done.said.front().help;
}

}  // namespace

TEST_CASE("a vector without its brackets is shown with them", "[reading]") {
    const auto [script, help] = GENERATE(table<std::string, std::string>({
        {"sphere { 0, 1 translate 1, 2, 3 }", "write `translate <1, 2, 3>`"},
        {"sphere { 0, 1 scale -1 2 }", "write `scale <-1, 2>`"},
        {"sphere { 0, 1 rotate 2*A, 0, 0 }", "write `rotate <x, y, z>`"},
        {"camera { look_at 0, 1, 0 }", "write `look_at <0, 1, 0>`"},
        {"sphere { 0, 1 pigment { rgb 1, 0, 0 } }", "write `rgb <1, 0, 0>`"},
        {"background { color rgb A, 0, 0 }", "write `color rgb <r, g, b>`"},
        {"sphere { 1, 0, 0, A }", "write `sphere { <1, 0, 0>, radius }`"},
        {"box { -1, -1, -1, 1, 1, 1 }", "write `box { <-1, -1, -1>, <1, 1, 1> }`"},
        {"cone { 0, 0, 0, 1, 0, 1, 0, 0.5 }", "write `cone { <0, 0, 0>, 1, <0, 1, 0>, 0.5 }`"},
        {"sphere { 0, 1 translate A rotate 4 scale 2 }", "nothing"},
        {"sphere { <0, 0, 0>, 1, 2 }", "sphere { centre, radius }"},
        {"sphere { 0, 1 translate x 2 }", "write `translate x*2`"},
    }));
    CHECK(advice(script) == help);
}

}  // namespace candelabra
