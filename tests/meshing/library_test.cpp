// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/library.h"

#include "cgal/shapes.h"

namespace candelabra {

TEST_CASE("corners at one place become one point of a polyhedron", "[modelling]") {
    Mesh apart;
    const Polyhedron cube = unit_cube(1, 2, 3);
    for (const auto& [a, b, c] : cube.faces) {
        const int first = static_cast<int>(apart.vertices.size());
        for (const int i : {a, b, c}) {
            const auto& p = cube.points[static_cast<std::size_t>(i)];
            apart.vertices.push_back({p[0], p[1], p[2]});
        }
        apart.faces.push_back({first, first + 1, first + 2});
    }
    const Polyhedron made = polyhedron(apart);
    CHECK(made.points.size() == 8);
    CHECK(made.faces.size() == 12);
    CHECK(volume(made) == Approx(1));
    CHECK(bounds(build(mesh(made))).low == Vec3(1, 2, 3));
}

TEST_CASE("the normals of a smooth cube point away from its centre", "[modelling]") {
    const Mesh made = smooth_mesh(unit_cube(-0.5, -0.5, -0.5));
    REQUIRE(made.normals.size() == 8);
    for (std::size_t i = 0; i < 8; ++i)
        CHECK(dot(made.normals[i], unit(made.vertices[i])) == Approx(1));
}

TEST_CASE("a mesh that cannot be read is an error where it is asked for", "[modelling]") {
    Diagnostics diagnostics;
    CHECK_FALSE(read_mesh_file({"/nowhere/nothing.txt", "x"}, diagnostics, {}));
    REQUIRE(diagnostics.all().size() == 1);
    CHECK(diagnostics.all()[0].message ==
          "cannot read the mesh `/nowhere/nothing.txt`: it is no OBJ, PLY, STL or OFF file, or is "
          "damaged");
}

}  // namespace candelabra
