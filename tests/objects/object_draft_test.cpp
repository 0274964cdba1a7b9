// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/object_draft.h"

#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a declared object that is moved shares what it holds", "[objects]") {
    const Script done =
        run("#version 3.7; #declare U = union { sphere { 0, 1 } sphere { x, 1 } } "
            "object { U } object { U translate x } object { U scale 2 }");
    REQUIRE(done.text.empty());
    const auto inner = [&](std::size_t i) {
        return std::get<Union>(done.object(i).form).children.at(0);
    };
    CHECK(inner(0) == inner(1));
    CHECK(inner(1) == inner(2));
    CHECK(done.object(2).transform->point(Vec3(1)) == Vec3(2));
}

TEST_CASE("a declared union that is changed keeps its parts and its place", "[objects]") {
    const Script done =
        run("#version 3.7; #declare U = union { sphere { 0, 1 } sphere { x, 1 } pigment { checker "
            "} translate x } "
            "object { U translate x pigment { rgb 1 } } object { U no_shadow }");
    REQUIRE(done.text.empty());
    const auto& parts = std::get<Union>(done.object(0).form).children;
    REQUIRE(parts.size() == 2);
    CHECK(done.object(0).transform->point(Vec3(0)) == Vec3(2, 0, 0));
    CHECK_FALSE(done.texture(0).pigment.pattern);
    CHECK(done.object(1).no_shadow);
    CHECK(done.object(1).transform->point(Vec3(0)) == Vec3(1, 0, 0));
    CHECK(done.texture(1).pigment.transform.point(Vec3(0)) == Vec3(1, 0, 0));
}

TEST_CASE("what is given before a transform moves with it, what is given after does not",
          "[objects]") {
    const Script done =
        run("#version 3.7; sphere { 0, 1 pigment { checker } translate x } sphere { 0, 1 translate "
            "x pigment { checker } } "
            "#declare A = sphere { 0, 1 pigment { checker } translate x } object { A scale 2 }");
    REQUIRE(done.text.empty());
    CHECK(done.texture(0).pigment.transform.point(Vec3(0)) == Vec3(1, 0, 0));
    CHECK(done.texture(1).pigment.transform.point(Vec3(0)) == Vec3(0, 0, 0));
    CHECK(done.texture(2).pigment.transform.point(Vec3(0)) == Vec3(2, 0, 0));
    CHECK(done.object(2).transform->point(Vec3(0)) == Vec3(2, 0, 0));
}

}  // namespace candelabra
