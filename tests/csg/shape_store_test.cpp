// SPDX-License-Identifier: GPL-3.0-or-later
#include "csg/shape_store.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

const BuiltLathe* lathe(const BuiltShape& shape) { return &*std::get<Shared<BuiltLathe>>(shape); }

}  // namespace

TEST_CASE("a shape that several objects share is built once", "[solid]") {
    ShapeStore store;
    const Shape top = Shared(Lathe{linear_curve, {{0, 0}, {1, 1}, {0, 2}}});
    const Shape copy = top, same = Shared(Lathe{linear_curve, {{0, 0}, {1, 1}, {0, 2}}});
    const BuiltShape first = store.built(top);
    CHECK(lathe(store.built(copy)) == lathe(first));
    CHECK(lathe(store.built(same)) != lathe(first));
}

TEST_CASE("shapes that need no building are copied", "[solid]") {
    ShapeStore store;
    CHECK(std::get<Sphere>(store.built(Sphere{Vec3(1), 2})).radius == 2);
    const Shape triangle = Shared(Triangle{});
    CHECK(&*std::get<Shared<Triangle>>(store.built(triangle)) ==
          &*std::get<Shared<Triangle>>(triangle));
}

TEST_CASE("a smooth landscape is made for the place that stretches it", "[solid]") {
    ShapeStore store;
    HeightField field;
    field.smooth = true;
    field.grid = make_handle<HeightGrid>(HeightGrid{2, 2, {0, 9000, 12000, 11000}});
    const Shape shape = Shared(field);
    const auto wide = make_handle<Transform>(Transform::scaling(Vec3(9, 1, 9)));
    const auto large = make_handle<Transform>(Transform::scaling(Vec3(9)));
    const auto landscape = [&](const Handle<Transform>& place) {
        return &*std::get<Shared<BuiltHeightField>>(store.built(shape, place));
    };
    CHECK(landscape(large) == landscape(nullptr));
    CHECK(landscape(wide) == landscape(wide));
    CHECK(landscape(wide)->stretched.get() == wide.get());
    const auto slope = [&](const Handle<Transform>& place) {
        Crossings found;
        crossings(*landscape(place), Ray{Vec3(0.25, 3, 0.5), Vec3(0, -1, 0)}, found);
        REQUIRE(found.size() == 1);
        return found[0].normal;
    };
    CHECK(length(slope(wide) - slope(nullptr)) > 1e-4);
}

TEST_CASE("a patch is divided until it is flat at its place", "[solid]") {
    ShapeStore store;
    BicubicPatch patch;
    patch.type = 1;
    patch.flatness = 0.1;
    patch.u_steps = patch.v_steps = 5;
    for (int i = 0; i < 16; ++i) patch.points.push_back(Vec3(i % 4, i / 4, (i % 4) * (i % 3)));
    const Shape shape = Shared(patch);
    const auto built_for = [&](const Vec3& scale) {
        const auto place = make_handle<Transform>(Transform::scaling(scale));
        return std::get<Shared<BuiltBicubicPatch>>(store.built(shape, place));
    };
    const auto facets = [&](const Vec3& scale) { return built_for(scale)->facets.size(); };
    patch.flatness = 0.1 / 4;
    CHECK(facets(Vec3(4)) == build(patch).facets.size());
    CHECK(facets(Vec3(1, 4, 2)) == facets(Vec3(4)));
    CHECK(facets(Vec3(4)) > facets(Vec3(1)));
    CHECK(facets(Vec3(0.1)) < facets(Vec3(1)));
    CHECK(&*built_for(Vec3(4)) == &*built_for(Vec3(4)));
}

TEST_CASE("a patch is made for a place that mirrors it", "[solid]") {
    ShapeStore store;
    BicubicPatch patch;
    patch.type = 1;
    for (int i = 0; i < 16; ++i) patch.points.push_back(Vec3(i % 4, i / 4, 0));
    const Shape shape = Shared(patch);
    const auto normal = [&](const Vec3& scale) {
        const auto place = make_handle<Transform>(Transform::scaling(scale));
        const BuiltShape built = store.built(shape, place);
        return std::get<Shared<BuiltBicubicPatch>>(built)->facets.front().normals.front();
    };
    CHECK(normal(Vec3(2, 1, 1)) == normal(Vec3(1)));
    CHECK(normal(Vec3(-1, 1, 1)) == -normal(Vec3(1)));
}

}  // namespace candelabra
