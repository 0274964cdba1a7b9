// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/waveform.h"

#include "pattern/values.h"

namespace candelabra {

TEST_CASE("waves, frequency and phase have POV-Ray's values", "[pattern]") {
    check_patterns({
        {"gradient <1,2,3> ramp_wave frequency 1.7 phase 0.2",
         {0.699778539, 0.759921694, 0.864224109, 0.547762990}},
        {"gradient y ramp_wave frequency -1.7 phase -0.2",
         {0.610009964, 0.610009964, 0.544999990, 0.325042705}},
        {"gradient <1,2,3> triangle_wave frequency 1.7 phase 0.2",
         {0.600442921, 0.480156612, 0.271551781, 0.904474021}},
        {"gradient y triangle_wave frequency -1.7 phase -0.2",
         {0.779980073, 0.779980073, 0.910000020, 0.650085409}},
        {"gradient <1,2,3> sine_wave frequency 1.7 phase 0.2",
         {0.024687197, 0.000971249, 0.123336959, 0.352190356}},
        {"gradient y sine_wave frequency -1.7 phase -0.2",
         {0.181263887, 0.181263887, 0.360504478, 0.945442339}},
        {"gradient <1,2,3> scallop_wave frequency 1.7 phase 0.2",
         {0.809425744, 0.684726416, 0.413734709, 0.988763327}},
        {"gradient y scallop_wave frequency -1.7 phase -0.2",
         {0.940870165, 0.940870165, 0.990023662, 0.852710255}},
        {"gradient <1,2,3> cubic_wave frequency 1.7 phase 0.2",
         {0.783720901, 0.854762292, 0.949700805, 0.571426561}},
        {"gradient y cubic_wave frequency -1.7 phase -0.2",
         {0.662352222, 0.662352222, 0.567317735, 0.248274962}},
        {"gradient <1,2,3> poly_wave 2.5 frequency 1.7 phase 0.2",
         {0.409639237, 0.503410311, 0.694330022, 0.222065818}},
        {"gradient y poly_wave 2.5 frequency -1.7 phase -0.2",
         {0.290631258, 0.290631258, 0.219276068, 0.060235297}},
    });
}

TEST_CASE("triangle runs up and down, also below 0", "[pattern]") {
    CHECK(triangle(0.25) == 0.5);
    CHECK(triangle(0.75) == 0.5);
    CHECK(triangle(7.5) == 1);
    CHECK(triangle(-0.25) == 0.5);
    CHECK(triangle(-1) == 0);
}

TEST_CASE("a frequency of 0 leaves values as they are", "[pattern]") {
    PatternModifiers modifiers;
    modifiers.frequency = 0;
    modifiers.phase = 0.3;
    CHECK(waved(RampWave{}, modifiers, 5) == 5);
    CHECK(waved(RampWave{}, modifiers, -0.25) == 0.75);
}

TEST_CASE("the wave is the pattern's, or the last one that is said", "[pattern]") {
    CHECK(std::holds_alternative<TriangleWave>(pattern_of("marble").wave));
    CHECK(std::holds_alternative<RampWave>(pattern_of("onion").wave));
    CHECK(std::holds_alternative<SineWave>(pattern_of("marble sine_wave").wave));
    CHECK(std::get<PolyWave>(pattern_of("onion poly_wave").wave).exponent == 1);
    CHECK(std::get<PolyWave>(pattern_of("onion sine_wave poly_wave 3").wave).exponent == 3);
}

}  // namespace candelabra
