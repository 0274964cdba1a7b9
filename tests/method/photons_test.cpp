// SPDX-License-Identifier: GPL-3.0-or-later
#include "method/photons.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("photons go a way that one side opens and none closes", "[method]") {
    using enum PhotonWay;
    CHECK_FALSE(is_open(unsaid, unsaid));
    CHECK(is_open(on, unsaid));
    CHECK(is_open(unsaid, on));
    CHECK(is_open(on, on));
    CHECK_FALSE(is_open(on, off));
    CHECK_FALSE(is_open(off, on));
    CHECK_FALSE(is_open(off, unsaid));
}

TEST_CASE("what is not said of photons is known as such", "[method]") {
    ObjectPhotons object;
    CHECK(object.ways() == PhotonWays());
    object.refraction = 0;
    object.reflection = 1;
    CHECK(object.ways() == PhotonWays{PhotonWay::on, PhotonWay::off});
    LightPhotons light;
    light.refraction = 1;
    CHECK(light.ways() == PhotonWays{PhotonWay::unsaid, PhotonWay::on});
}

TEST_CASE("the number of photons is said by one of two words", "[method]") {
    PhotonSettings settings;
    settings.on = true;
    CHECK_FALSE(settings.shoots());
    settings.spacing = 0.1;
    CHECK(settings.shoots());
    CHECK(PhotonSettings::vocabulary.name == "photons");
}

}  // namespace candelabra
