// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/convert.h"

#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a rule reads like a sentence", "[reading]") {
    CHECK(rule(above(0)) == "above 0");
    CHECK(rule(at_least(0)) == "at least 0");
    CHECK(rule(between(1, 5)) == "from 1 to 5");
    CHECK(rule(Range{0, 360, true}) == "above 0 and at most 360");
}

TEST_CASE("the offender is the component that is out of range", "[reading]") {
    const FieldValue vector = Vec3(1, -2, 3);
    REQUIRE(offender(at_least(0), vector));
    CHECK(*offender(at_least(0), vector) == -2);
    CHECK_FALSE(offender(at_least(-2), vector));
    CHECK_FALSE(offender(at_least(0), FieldValue(std::string("text"))));
}

TEST_CASE("colours are taken where only red, green and blue count", "[reading]") {
    const Script done =
        run("#version 3.7; sphere { 0, 1 finish { ambient 0.5 emission rgbt <1, 2, 3, 0.4> } } "
            "background { <1, 2, 3> }");
    REQUIRE(done.text.empty());
    CHECK(done.texture().finish.ambient == Rgb(0.5));
    CHECK(done.texture().finish.emission == Rgb(1, 2, 3));
    CHECK(done.scene.background.colour == Colour{Rgb(1, 2, 3)});
}

TEST_CASE("no field takes what is not finite", "[reading]") {
    const Script done = run("#version 3.7; sphere { 1/0, 1 }");
    REQUIRE(done.said.size() == 2);
    CHECK(done.said[0].fault == Fault::division_by_zero);
    CHECK(done.said[1].message == "`centre` of `sphere` must be finite, but it is inf");
}

TEST_CASE("numbers that surely fit a field are set, others left to the long way", "[reading]") {
    Sphere sphere;
    const ItemInfo& info = Sphere::vocabulary;
    CHECK(set_fitting(info, &sphere, 0, Numbers::vector(Vec3(1, 2, 3))));
    CHECK(set_fitting(info, &sphere, 1, Numbers::scalar(4)));
    CHECK((sphere.centre == Vec3(1, 2, 3) && sphere.radius == 4));
    CHECK(set_fitting(info, &sphere, 0, Numbers::scalar(7)));
    CHECK(sphere.centre == Vec3(7));
    CHECK(set_fitting(info, &sphere, 0, Numbers{{1, 2}, 2}));
    CHECK(sphere.centre == Vec3(1, 2, 0));
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK_FALSE(set_fitting(info, &sphere, 0, Numbers::scalar(infinity)));
    CHECK_FALSE(set_fitting(info, &sphere, 0, Numbers{{1, 2, 3, 4}, 4}));
    CHECK_FALSE(set_fitting(info, &sphere, 1, Numbers{{1, 2}, 2}));
    CHECK_FALSE(set_fitting(info, &sphere, 1, Numbers::scalar(-1)));
    CHECK((sphere.centre == Vec3(1, 2, 0) && sphere.radius == 4));
}

}  // namespace candelabra
