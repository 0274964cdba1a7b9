// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/media.h"

#include "support/script.h"
#include "surface/pigment_map.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("media have coefficients, scattering, densities and hints", "[appearance]") {
    const Script done = run(R"(#version 3.7;
        #declare Haze = media { scattering { 5, rgb <0.1, 0.2, 0.3> eccentricity 0.4 extinction 0.5 } }
        #declare Round = density { spherical scale 2 }
        media { Haze emission 0.5 absorption rgb <1, 2, 3> absorption 4
                density { Round } density { gradient y density_map { [0 rgb 0] [1 bozo] } }
                method 3 intervals 2 samples 5, 20 confidence 0.9 variance 0.01 ratio 0.5 jitter 0.1
                aa_level 4 aa_threshold 0.2 collect off translate x density { rgb 2 } }
        sphere { 0, 1 hollow interior { ior 1.1 media { Haze } media { emission 1 } } })");
    INFO(done.text);
    REQUIRE(done.said.size() == 1);
    CHECK(done.said[0].message ==
          "`method`, `aa_level`, `aa_threshold`, `confidence`, `variance`, `ratio`, `jitter` of "
          "`media` have no effect: light between surfaces is estimated without bias in any case");
    REQUIRE(done.scene.media.size() == 1);
    const Media& media = done.scene.media[0];
    CHECK(media.scattering.type == 5);
    CHECK(media.scattering.colour == Rgb(0.1, 0.2, 0.3));
    CHECK(media.scattering.eccentricity == 0.4);
    CHECK(media.scattering.extinction == 0.5);
    CHECK(media.absorption == Rgb(4));
    CHECK(media.emission == Rgb(0.5));
    CHECK(media.samples == 5);
    CHECK(media.max_samples == 20);
    CHECK(media.intervals == 2);
    CHECK_FALSE(media.collect);
    REQUIRE(media.densities.size() == 3);
    CHECK(media.densities[0].transform.point(Vec3(1, 0, 0)) == Vec3(3, 0, 0));
    CHECK(std::holds_alternative<PigmentMap>(media.densities[1].pattern->map));
    CHECK(media.densities[2].colour.rgb == Rgb(2));
    const Object& sphere = *done.scene.objects.at(0);
    REQUIRE(sphere.interior);
    CHECK(sphere.interior->media.size() == 2);
}

TEST_CASE("an interior says that its media light the scene, if they emit", "[appearance]") {
    const Script done = run(R"(#version 3.7;
        #declare Flame = interior { media { emission 1 } luminaire }
        sphere { 0, 1 interior { Flame } }
        sphere { 0, 1 interior { Flame luminaire off } }
        sphere { 0, 1 interior { media { absorption 1 } luminaire } })");
    INFO(done.text);
    REQUIRE(done.said.size() == 1);
    CHECK(done.said[0].message ==
          "`luminaire` has no effect: no media of the interior emit light");
    CHECK(done.scene.objects.at(0)->interior->luminaire);
    CHECK_FALSE(done.scene.objects.at(1)->interior->luminaire);
}

TEST_CASE("densities move with what is in them, as they were written", "[appearance]") {
    const Script done = run(R"(#version 3.7;
        sphere { 0, 1 translate 5*y
                 interior { media { absorption 1 density { spherical } } } translate 2*x }
        sphere { 0, 1 interior { media { absorption 1 } } scale 3 }
        box { 0, 1 material { interior { media { emission 1 density { bozo } } } scale 2 }
              translate z })");
    INFO(done.text);
    REQUIRE(done.text.empty());
    const auto moved_to = [&](std::size_t object) {
        return done.scene.objects.at(object)->interior->media.at(0).densities.at(0).transform;
    };
    CHECK(moved_to(0).point(Vec3(0)) == Vec3(2, 0, 0));
    CHECK(done.scene.objects.at(1)->interior->media.at(0).densities.empty());
    CHECK(moved_to(2).point(Vec3(1)) == Vec3(2, 2, 3));
}

TEST_CASE("wrong media are told of", "[appearance]") {
    CHECK(complaint("media { scattering { 1, 0.1 eccentricity 0.5 } }") ==
          "error misplaced: `eccentricity` belongs to scattering of type 5");
    CHECK(complaint("media { intervals 0 }") ==
          "error out-of-range: `intervals` of `media` must be at least 1, but it is 0");
    CHECK(complaint("media { method 4 }") ==
          "error out-of-range: `method` of `media` must be from 1 to 3, but it is 4");
    CHECK(complaint("media { turbulence 1 }").find("misplaced") != std::string::npos);
    CHECK(complaint("media { density { bozo pigment_map { [0 rgb 1] } } }").find("error") == 0);
}

}  // namespace candelabra
