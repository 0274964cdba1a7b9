// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/air_photons.h"

#include "support/draw.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Photons spread evenly over a cube of side 1, which stand for light of colour 1 in all of it.
std::vector<Photon> cube_of(int count) {
    Draw draw(3);
    std::vector<Photon> photons;
    for (int i = 0; i < count; ++i)
        photons.push_back({draw.point(0.5), glm::vec3(0, -1, 0), glm::vec3(0),
                           glm::vec3(1.0F / static_cast<float>(count))});
    return photons;
}

/// Integral of the light along a ray.
double light_along(const AirPhotonMap& map, const Ray& ray, double until) {
    double sum = 0;
    map.along(ray, until, [&](const Photon& photon, double, double away2) {
        sum += photon.power.x * air_photon_density(photon, away2);
    });
    return sum;
}

}  // namespace

TEST_CASE("photons that fill the air evenly give even light", "[transport]") {
    const AirPhotonMap map(cube_of(1 << 15), {.wanted = 20});
    const auto mean = [&](double from, double until) {
        constexpr int rays = 20;
        double sum = 0;
        for (int i = 0; i < rays * rays; ++i)
            sum +=
                light_along(map,
                            {Vec3(i % rays - 9.5, i / rays - 9.5, 0) * 0.03 + from * Vec3(0, 0, 1),
                             Vec3(0, 0, 1)},
                            until);
        return sum / (rays * rays);
    };
    CHECK(mean(-3, 9) == Approx(1).epsilon(0.015));
    CHECK(mean(-3, 3) == Approx(0.5).epsilon(0.02));
    CHECK(mean(0, 9) == Approx(0.5).epsilon(0.02));
    CHECK(light_along(map, {Vec3(3, 0, -3), Vec3(0, 0, 1)}, 9) == 0);
    CHECK(light_along(AirPhotonMap(), {Vec3(0), Vec3(0, 0, 1)}, 9) == 0);
}

TEST_CASE("balls hold about as many photons as are wanted", "[transport]") {
    const AirPhotonMap map(cube_of(1 << 15), {.wanted = 20});
    double mean = 0;
    for (const Photon& photon : map.photons()) mean += photon.radius / (1 << 15);
    const double expected = std::cbrt(20.0 / (1 << 15) / (4.0 / 3 * std::numbers::pi));
    CHECK(mean == Approx(expected).epsilon(0.2));
    const AirPhotonMap set(cube_of(100), {.wanted = 20, .shrunk = 0.5, .radius = 0.3});
    for (const Photon& photon : set.photons()) CHECK(photon.radius == Approx(0.15));
}

TEST_CASE("a ray finds the photons that a look at all of them does", "[transport]") {
    Draw draw(4);
    const AirPhotonMap map(cube_of(500), {.wanted = 8});
    for (int i = 0; i < 50; ++i) {
        const Ray ray{draw.point(1), draw.direction()};
        std::size_t met = 0, all = 0;
        map.along(ray, 1, [&](const Photon&, double, double) { ++met; });
        for (const Photon& photon : map.photons()) {
            const Vec3 offset = photon.position - ray.origin;
            const double distance = dot(offset, ray.direction);
            const double away2 = dot(offset, offset) - distance * distance;
            if (distance > 0 && distance < 1 && away2 < photon.radius * photon.radius) ++all;
        }
        CHECK(met == all);
    }
}

TEST_CASE("a photon gives all that it has across the ray", "[transport]") {
    Photon photon;
    photon.radius = 2;
    double sum = 0;
    constexpr int rings = 1000;
    for (int i = 0; i < rings; ++i) {
        const double away = 2 * (i + 0.5) / rings;
        sum += air_photon_density(photon, away * away) * 2 * std::numbers::pi * away * 2 / rings;
    }
    CHECK(sum == Approx(1).epsilon(1e-4));
    CHECK(air_photon_density(photon, 4) == 0);
}

}  // namespace candelabra
