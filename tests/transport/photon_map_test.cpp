// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/photon_map.h"

#include "base/random.h"

#include <catch2/catch.hpp>
#include <numbers>

namespace candelabra {

namespace {

/// Photons spread evenly over a floor of side 1.
std::vector<Photon> floor_of(std::uint32_t count) {
    std::vector<Photon> photons;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Key key{5, i, 0, 0};
        photons.push_back({Vec3(uniform(key, Purpose::pixel_x), 0, uniform(key, Purpose::pixel_y)),
                           glm::vec3(0, -1, 0), glm::vec3(0, 1, 0),
                           glm::vec3(1.0F / static_cast<float>(count))});
    }
    return photons;
}

double light_at(const PhotonMap& map, const Vec3& point) {
    double sum = 0;
    map.around(point, [&](const Photon& photon) {
        sum += photon.power.x * photon_density(photon, point, Vec3(0, 1, 0));
    });
    return sum;
}

}  // namespace

TEST_CASE("photons that lie evenly give even light", "[transport]") {
    const PhotonMap map(floor_of(1 << 14), {.wanted = 100});
    for (const Vec3& point : {Vec3(0.5, 0, 0.5), Vec3(0.3, 0, 0.7), Vec3(0.62, 0, 0.41)})
        CHECK(light_at(map, point) == Approx(1).epsilon(0.03));
    CHECK(light_at(map, Vec3(2, 0, 0)) == 0);
}

TEST_CASE("discs hold about as many photons as are wanted", "[transport]") {
    const PhotonMap map(floor_of(1 << 14), {.wanted = 100});
    double mean = 0;
    for (const Photon& photon : map.photons()) mean += photon.radius / (1 << 14);
    CHECK(mean == Approx(std::sqrt(100 / (std::numbers::pi * (1 << 14)))).epsilon(0.15));
}

TEST_CASE("a photon gives what it has to the surface that it is on", "[transport]") {
    Photon photon{Vec3(0), glm::vec3(0, -1, 0), glm::vec3(0, 1, 0), glm::vec3(1), 2};
    // The integral of its density over its disc, by rings.
    double sum = 0;
    constexpr int rings = 1000;
    for (int i = 0; i < rings; ++i) {
        const double away = 2 * (i + 0.5) / rings;
        sum += photon_density(photon, Vec3(away, 0, 0), Vec3(0, 1, 0)) * 2 * std::numbers::pi *
               away * 2 / rings;
    }
    CHECK(sum == Approx(1).epsilon(1e-4));
    CHECK(photon_density(photon, Vec3(0.1, 0, 0), Vec3(1, 0, 0)) == 0);
    CHECK(photon_density(photon, Vec3(0, 1.5, 0), Vec3(0, 1, 0)) == 0);
    CHECK(photon_density(photon, Vec3(2.1, 0, 0), Vec3(0, 1, 0)) == 0);
}

TEST_CASE("one that strays does not widen the discs of those that are dense", "[transport]") {
    std::vector<Photon> photons = floor_of(50);
    photons.push_back(photons.front());
    photons.back().position = Vec3(1000, 0, 0);
    const PhotonMap map(std::move(photons), {.wanted = 60});
    int wide = 0;
    for (const Photon& photon : map.photons()) wide += photon.radius > 3;
    CHECK(wide <= 16);
}

TEST_CASE("a map may be empty, or of few photons", "[transport]") {
    CHECK(light_at(PhotonMap({}, {}), Vec3(0)) == 0);
    const PhotonMap few(floor_of(3), {.unknown = 0.25});
    for (const Photon& photon : few.photons()) CHECK(photon.radius == 0.25F);
    const PhotonMap fixed(floor_of(300), {.shrunk = 0.5, .radius = 0.1});
    for (const Photon& photon : fixed.photons()) CHECK(photon.radius == 0.05F);
}

}  // namespace candelabra
