// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/photometric_web.h"

#include "photometry/web_table.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

PhotometricWeb completed(WebTable table) {
    PhotometricWeb web;
    std::string symmetry;
    std::vector<std::string> notes;
    REQUIRE(complete_table(std::move(table), web, symmetry, notes) == "");
    return web;
}

PhotometricWeb axial(std::vector<double> vertical, std::vector<double> candela) {
    return completed({WebType::c, std::move(vertical), {0}, std::move(candela)});
}

/// The integral over the sphere by equal parts of z and of longitude.
double summed(const PhotometricWeb& web, int parts) {
    double sum = 0;
    for (int i = 0; i < parts; ++i)
        for (int j = 0; j < 2 * parts; ++j) {
            const double z = 2 * (i + 0.5) / parts - 1,
                         around = std::numbers::pi * (j + 0.5) / parts;
            const double across = std::sqrt(1 - z * z);
            sum += web.intensity({across * std::cos(around), across * std::sin(around), z});
        }
    return 4 * std::numbers::pi * sum / (2.0 * parts * parts);
}

}  // namespace

TEST_CASE("the flux of a web is the exact integral of what it shows", "[photometry]") {
    CHECK(axial({0, 30, 60, 90}, {300, 250, 120, 0}).flux() == Approx(821.033).epsilon(1e-6));
    CHECK(axial({0, 30, 60, 90, 120, 150, 180}, std::vector<double>(7, 100)).flux() ==
          Approx(400 * std::numbers::pi));
    const PhotometricWeb upward = axial({0, 30, 60, 90, 120}, {300, 250, 120, 20, 0});
    CHECK(upward.flux() - upward.flux_down() == Approx(32.1539).epsilon(1e-5));
    // The horizontal lies between two angles.
    const PhotometricWeb even = axial({0, 80, 100, 180}, {50, 50, 50, 50});
    CHECK(even.flux_down() == Approx(100 * std::numbers::pi));
    const std::vector<double> four = {10, 90, 40, 0, 30, 20, 80, 0, 5, 60, 20, 10, 70, 15, 90, 3};
    for (const WebType type : {WebType::c, WebType::b, WebType::a}) {
        CAPTURE(static_cast<int>(type));
        const bool around = type == WebType::c;
        const PhotometricWeb web = completed(
            {type,
             around ? std::vector<double>{0, 40, 100, 180} : std::vector<double>{-90, -20, 40, 90},
             around ? std::vector<double>{0, 90, 200, 300} : std::vector<double>{-80, -30, 20, 90},
             four});
        // The sum is rough where a table ends in light.
        CHECK(web.flux() == Approx(summed(web, 600)).epsilon(around ? 2e-4 : 1.5e-3));
    }
}

TEST_CASE("angles and directions are inverses of each other", "[photometry]") {
    for (const WebType type : {WebType::c, WebType::b, WebType::a})
        for (const Vec3& direction :
             {Vec3(1, 0, 0), Vec3(0.3, -0.5, 0.2), Vec3(-0.4, 0.1, -0.9), Vec3(0, 0, -1)}) {
            const Vec3 again = direction_of(type, angles_of(type, direction));
            CHECK(length(again - unit(direction)) < 1e-12);
        }
    CHECK(length(direction_of(WebType::c, {90, 90}) - Vec3(0, 1, 0)) < 1e-12);
    CHECK(length(direction_of(WebType::b, {90, 0}) - Vec3(1, 0, 0)) < 1e-12);
    CHECK(length(direction_of(WebType::a, {0, 90}) - Vec3(0, -1, 0)) < 1e-12);
}

TEST_CASE("a table is linear between its angles, and dark outside", "[photometry]") {
    const PhotometricWeb web = axial({0, 60}, {100, 40});
    CHECK(web.intensity(WebAngles{30, 77}) == Approx(70));
    CHECK(web.intensity(WebAngles{60, -400}) == Approx(40));
    CHECK(web.intensity(WebAngles{61, 0}) == 0);
    CHECK(web.greatest() == 100);
    CHECK(PhotometricWeb().flux() == 0);
    CHECK(PhotometricWeb().intensity(Vec3(0, 0, 1)) == 0);
}

}  // namespace candelabra
