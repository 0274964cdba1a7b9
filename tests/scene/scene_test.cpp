// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a light takes with it what belongs to it", "[scene]") {
    PlacedLight placed{PointLight{}, {}};
    placed.looks_like = make_handle<Object>();
    placed.looks_like.edit().no_shadow = true;
    placed.projected_through = make_handle<Object>();
    const PlacedLight there = transformed(placed, Transform::translation(Vec3(1, 2, 3)));
    CHECK(there.light.location == Vec3(1, 2, 3));
    for (const ObjectHandle& object : {there.looks_like, there.projected_through})
        CHECK(object->transform->point(Vec3(0)) == Vec3(1, 2, 3));
    CHECK(there.looks_like->no_shadow);
    CHECK_FALSE(there.projected_through->no_shadow);
    // Further transformations do not deepen the nesting.
    const PlacedLight further = transformed(there, Transform::scaling(Vec3(2)));
    for (const ObjectHandle& object : {further.looks_like, further.projected_through}) {
        CHECK(object->transform->point(Vec3(0)) == Vec3(2, 4, 6));
        CHECK(object->depth <= 1);
    }
    CHECK(further.looks_like->no_shadow);
}

TEST_CASE("however often an object is moved, it is wrapped once at most", "[scene]") {
    const Transform step = Transform::translation(Vec3(1, 0, 0));
    ObjectHandle plain = make_handle<Object>(), textured = make_handle<Object>();
    textured.edit().texture = make_handle<Texture>();
    const ObjectHandle inner = textured;
    for (int i = 0; i < 3; ++i) {
        plain = transformed(plain, step);
        textured = transformed(textured, step);
    }
    CHECK(std::holds_alternative<Shape>(plain->form));
    CHECK(plain->transform->point(Vec3(0)) == Vec3(3, 0, 0));
    CHECK(std::get<Union>(textured->form).children == std::vector{inner});
    CHECK(textured->transform->point(Vec3(0)) == Vec3(3, 0, 0));
    CHECK_FALSE(textured->texture);
}

}  // namespace candelabra
