// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene.h"

#include <catch2/catch.hpp>

TEST_CASE("a light takes with it what belongs to it", "[scene]") {
    PlacedLight placed{PointLight{}, {}};
    placed.looks_like = make_handle<Object>();
    placed.looks_like.edit().no_shadow = true;
    placed.projected_through = make_handle<Object>();
    const PlacedLight there = moved(placed, Transform::translation(Vec3(1, 2, 3)));
    CHECK(std::get<PointLight>(there.light).location == Vec3(1, 2, 3));
    for (const ObjectHandle& object : {there.looks_like, there.projected_through})
        CHECK(object->transform->point(Vec3(0)) == Vec3(1, 2, 3));
    CHECK(there.looks_like->no_shadow);
    CHECK_FALSE(there.projected_through->no_shadow);
}
