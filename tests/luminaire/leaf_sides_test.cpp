// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/leaf_sides.h"

#include "support/axes.h"

#include <catch2/catch.hpp>

#include <utility>

namespace candelabra {

namespace {

/// A pyramid over the axes, whose faces are wound one way or the other.
Mesh pyramid(bool turned) {
    Mesh mesh;
    mesh.vertices = {o, x, y, z};
    mesh.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 2, 1}};
    if (turned)
        for (Face& face : mesh.faces) std::swap(face[0], face[1]);
    mesh.inside_vector = y;
    return mesh;
}

}  // namespace

TEST_CASE("what is inside tells the sides of a mesh, and not its windings", "[luminaire]") {
    for (const bool turned : {false, true}) {
        CompositeBuilder builder;
        const PartRef mesh = builder.add({built(Shape(Shared<Mesh>(pyramid(turned))))}),
                      cut = builder.add({Plane{x, 0.5}});
        const Composite whole = builder.finish(builder.add(Combination::common, {mesh, cut}));
        const LeafSides sides(whole, mesh.index, 1);
        const Ray line{Vec3(0.2, 0.2, -1), z};
        int met = 0;
        whole.all(
            line, Interval{0}, [&](std::uint32_t leaf) { return leaf == mesh.index; },
            [&](const Composite::Meeting& at) {
                ++met;
                CHECK(sides.leaves(line, at) == (at.t > 1.1));
            });
        CHECK(met == 2);
    }
}

}  // namespace candelabra
