// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/photons.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

const std::string glass_on_floor =
    R"(#version 3.7; #default { pigment { rgb 1 } } global_settings { photons { count 3000 } }
    light_source { <0, 90, 0>, rgb 1 photons { refraction on } }
    light_source { <9, 20, 0>, rgb 1 photons { refraction on } }
    sphere { <3, 9, 0>, 0.5 finish { emission 9 } }
    sphere { 2*y, 1 pigment { rgbt 1 } interior { ior 1.5 } photons { target refraction on } }
    sphere { <4, 2, 0>, 1 pigment { rgbt 1 } interior { ior 1.5 } photons { target } }
    box { <-20, -1, -20>, <20, 0, 20> })";

bool same(const PhotonMap& a, const PhotonMap& b) {
    if (a.photons().size() != b.photons().size()) return false;
    for (std::size_t i = 0; i < a.photons().size(); ++i) {
        const Photon &p = a.photons()[i], &q = b.photons()[i];
        if (p.position != q.position || p.power != q.power || p.radius != q.radius) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("a generation is the same for any number of threads and any order", "[transport]") {
    const Shot shot = shot_of(glass_on_floor);
    Photons one(shot, 0, 1), four(shot, 0, 4), other(shot, 1, 1);
    for (const std::uint32_t number : {3u, 4u, 5u}) four.generation(number);
    CHECK(same(one.generation(5)->on_surfaces, four.generation(5)->on_surfaces));
    CHECK(same(one.generation(0)->on_surfaces, four.generation(0)->on_surfaces));
    CHECK_FALSE(same(one.generation(0)->on_surfaces, one.generation(1)->on_surfaces));
    CHECK_FALSE(same(one.generation(0)->on_surfaces, other.generation(0)->on_surfaces));
    CHECK(one.generation(0)->on_surfaces.photons().size() > 1000);
}

TEST_CASE("generations that are far apart are made again", "[transport]") {
    const Shot shot = shot_of(glass_on_floor);
    Photons photons(shot, 0, 1);
    const auto first = photons.generation(0);
    for (std::uint32_t i = 1; i < 80; ++i) photons.generation(i);
    CHECK(same(first->on_surfaces, photons.generation(0)->on_surfaces));
}

TEST_CASE("radii shrink from generation to generation", "[transport]") {
    const Shot shot = shot_of(glass_on_floor);
    Photons photons(shot, 0, 1);
    const auto mean = [&](std::uint32_t number) {
        const auto map = photons.generation(number);
        double sum = 0;
        for (const Photon& photon : map->on_surfaces.photons()) sum += std::log(photon.radius);
        return std::exp(sum / static_cast<double>(map->on_surfaces.photons().size()));
    };
    CHECK(mean(63) / mean(0) == Approx(0.5).epsilon(0.1));
}

TEST_CASE("all lamps together send as much to the floor whatever the number", "[transport]") {
    const auto power = [](const std::string& count) {
        std::string scene = glass_on_floor;
        scene.replace(scene.find("3000"), 4, count);
        const Shot shot = shot_of(scene);
        Photons photons(shot, 0, 1);
        double sum = 0;
        for (std::uint32_t i = 0; i < 4; ++i)
            for (const Photon& photon : photons.generation(i)->on_surfaces.photons())
                sum += photon.power.x;
        return sum / 4;
    };
    CHECK(power("3000") == Approx(power("40000")).epsilon(0.03));
}

TEST_CASE("a world without targets has no photons", "[transport]") {
    CHECK_FALSE(photons_of(shot_of("sphere { 0, 1 }"), 0, 1));
    CHECK(photons_of(shot_of(glass_on_floor), 0, 1));
}

}  // namespace candelabra
