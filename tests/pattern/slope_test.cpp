// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/slope.h"

#include "pattern/values.h"

namespace candelabra {

namespace {

double slope_at(const std::string& text, const Vec3& normal, const Vec3& position = Vec3(0)) {
    const SurfaceView view{position, normal, Vec3(0, 0, 1)};
    PatternScene scene;
    scene.view = &view;
    return value_at(pattern_of(text), position, scene);
}

}  // namespace

TEST_CASE("slope grows with the angle towards its direction", "[pattern]") {
    CHECK(slope_at("slope 5*y", Vec3(0, 1, 0)) == Approx(1));
    CHECK(slope_at("slope y", Vec3(1, 0, 0)) == Approx(0.5));
    CHECK(slope_at("slope y", Vec3(0, -1, 0)) == Approx(0).margin(1e-12));
    CHECK(slope_at("slope y", unit(Vec3(0, 1, 1))) == Approx(0.75));
    CHECK(slope_at("slope { y, 0.5, 1 }", unit(Vec3(0, 1, 1))) == Approx(0.5));
    CHECK(slope_at("slope { y, 0.5, 1 }", unit(Vec3(0, -1, 1))) == Approx(0.5));
    CHECK(slope_at("slope { point_at <0, 9, 3> }", Vec3(0, 1, 0), Vec3(0, 0, 3)) == Approx(1));
    CHECK(slope_at("slope { point_at <0, 9, 3>, 0, 2 }", Vec3(0, 1, 0), Vec3(0, 0, 3)) ==
          Approx(0.5));
}

TEST_CASE("altitude is mixed in by the lengths", "[pattern]") {
    const Vec3 up(0, 1, 0);
    CHECK(slope_at("slope { y altitude y }", Vec3(1, 0, 0), 0.1 * up) == Approx(0.3));
    CHECK(slope_at("slope { y altitude 3*y, 1, 3 }", Vec3(1, 0, 0), 1.5 * up) ==
          Approx(0.25 * 0.5 + 0.75 * 0.25));
    CHECK(slope_at("slope { y altitude y }", up, up) == Approx(1));
}

TEST_CASE("aoi is the angle between normal and ray", "[pattern]") {
    CHECK(slope_at("aoi", Vec3(0, 0, -1)) == Approx(1));
    CHECK(slope_at("aoi", unit(Vec3(0, 1, -1))) == Approx(0.75));
}

TEST_CASE("where there is no surface, slope and aoi are 0", "[pattern]") {
    CHECK(value_at(pattern_of("slope y"), Vec3(1)) == 0);
    CHECK(value_at(pattern_of("aoi"), Vec3(1)) == 0);
}

}  // namespace candelabra
