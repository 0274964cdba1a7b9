// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/mesh_area.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("shares of a mesh's area lie in faces by their size", "[shape]") {
    Mesh mesh;
    mesh.vertices = {Vec3(0), Vec3(2, 0, 0), Vec3(0, 1, 0), Vec3(0, -3, 0)};
    mesh.faces = {{0, 1, 2}, {0, 0, 1}, {0, 3, 1}};
    const MeshArea area(mesh);
    CHECK(area.total() == Approx(4));
    struct Case {
        double share;
        std::size_t face;
        double part;
    };
    for (const Case& each : {Case{0, 0, 0}, Case{0.125, 0, 0.5}, Case{0.25, 2, 0},
                             Case{0.625, 2, 0.5}, Case{1, 2, 1}}) {
        CAPTURE(each.share);
        CHECK(area.at(each.share).index == each.face);
        CHECK(area.at(each.share).within == Approx(each.part).margin(1e-12));
    }
    CHECK(MeshArea(Mesh()).total() == 0);
}

}  // namespace candelabra
