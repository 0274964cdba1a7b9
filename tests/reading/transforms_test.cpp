// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/transforms.h"

#include "support/spheres.h"
#include "vocabulary/written.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Vec3 image_of(const std::string& modifiers, const Vec3& point) {
    const Script done = sphere_with(modifiers, "#declare T = transform { translate x }");
    REQUIRE(done.object().transform);
    return done.object().transform->point(point);
}

void check(const Vec3& found, const Vec3& expected) { CHECK(length(found - expected) < 1e-12); }

}  // namespace

TEST_CASE("transforms are applied in the order of the text", "[reading]") {
    check(image_of("scale 2 translate 1", Vec3(1, 2, 3)), Vec3(3, 5, 7));
    check(image_of("translate 1 scale 2", Vec3(1, 2, 3)), Vec3(4, 6, 8));
    check(image_of("rotate 90*z translate <1, 2>", Vec3(1, 0, 0)), Vec3(1, 3, 0));
    check(image_of("matrix <1, 2, 3, 4, 5, 6, 7, 8, 10, 11, 12, 13>", Vec3(1, 0, 0)),
          Vec3(12, 14, 16));
}

TEST_CASE("transform takes blocks and names, and inverts", "[reading]") {
    check(image_of("transform T", Vec3(0)), Vec3(1, 0, 0));
    check(image_of("transform { T scale 2 T }", Vec3(0)), Vec3(3, 0, 0));
    check(image_of("transform { inverse translate 1 scale 2 }", Vec3(4, 6, 8)), Vec3(1, 2, 3));
    check(image_of("transform { translate 1 scale 2 inverse inverse }", Vec3(4, 6, 8)),
          Vec3(1, 2, 3));
    check(image_of("transform { transform T transform { T inverse } }", Vec3(0)), Vec3(0));
}

TEST_CASE("a matrix may have the numbers of its inverse behind its own", "[reading]") {
    const Transform turned =
        Transform::rotation(Vec3(10, 20, 30)).then(Transform::scaling(Vec3(1, 2, 3)));
    const Transform many = turned.then(turned).then(Transform::translation(Vec3(0.1, 7, 9)));
    REQUIRE(many != Transform(many.forward()));
    const Script done = sphere_with(matrix_text(many), "");
    REQUIRE(done.object().transform);
    CHECK(*done.object().transform == many);
}

TEST_CASE("transforms that cannot be are told of", "[reading]") {
    CHECK(complaint("sphere { 0, 1 scale <1, 0, 1> }") ==
          "warning degenerate: this `scale` is 0 along an axis, which is taken as 1");
    CHECK(complaint("sphere { 0, 1 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1> }") ==
          "error wrong-count: `matrix` needs 12 numbers, but it has 9");
    CHECK(complaint("sphere { 0, 1 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 0, 0, "
                    "1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 0, 0> }") ==
          "warning degenerate: the last 12 numbers of this `matrix` are not those of its inverse, "
          "and do not count");
    CHECK(complaint("sphere { 0, 1 matrix }") ==
          "error wrong-count: `matrix` needs 12 numbers, but it has 0");
    CHECK(complaint("sphere { 0, 1 matrix <1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0> }") ==
          "error degenerate: this `matrix` makes everything flat");
    CHECK(complaint("sphere { 0, 1 matrix <1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0> }") ==
          "warning degenerate: a column of `matrix` is all 0, so its diagonal is taken as 1");
    CHECK(complaint("sphere { 0, 1 transform }") ==
          "error missing: `transform` needs a declared transform or a block");
    CHECK(complaint("sphere { 0, 1 transform 3 }") ==
          "error wrong-type: `transform` needs a declared transform, but this is a number");
    CHECK(complaint("sphere { 0, 1 transform { rotat x } }") ==
          "error unknown-word: `transform` has no word `rotat`");
}

}  // namespace candelabra
