// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/triangle_mesh.h"

#include "vocabulary/parts.h"
#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo FlatFacet::vocabulary = described<FlatFacet>([] {
    using F = Field<FlatFacet>;
    return schema<FlatFacet>("triangle", "A flat triangle of a mesh.",
                             F{"corner1", &FlatFacet::corner1, positional, "a corner"},
                             F{"corner2", &FlatFacet::corner2, positional, "a corner"},
                             F{"corner3", &FlatFacet::corner3, positional, "a corner"},
                             F{"uv_vectors", &FlatFacet::uv1, item, "u and v of the corners"},
                             F{"uv 2", &FlatFacet::uv2, following, "the second corner's"},
                             F{"uv 3", &FlatFacet::uv3, following, "the third corner's"});
});

const ItemInfo SmoothFacet::vocabulary = described<SmoothFacet>([] {
    using F = Field<SmoothFacet>;
    return schema<SmoothFacet>(
        "smooth_triangle", "A triangle of a mesh, shaded as if it were curved.",
        F{"corner1", &SmoothFacet::corner1, positional, "a corner"},
        F{"normal1", &SmoothFacet::normal1, positional, "the surface's normal there"},
        F{"corner2", &SmoothFacet::corner2, positional, "a corner"},
        F{"normal2", &SmoothFacet::normal2, positional, "the surface's normal there"},
        F{"corner3", &SmoothFacet::corner3, positional, "a corner"},
        F{"normal3", &SmoothFacet::normal3, positional, "the surface's normal there"},
        F{"uv_vectors", &SmoothFacet::uv1, item, "u and v of the corners"},
        F{"uv 2", &SmoothFacet::uv2, following, "the second corner's"},
        F{"uv 3", &SmoothFacet::uv3, following, "the third corner's"});
});

const ItemInfo TriangleMesh::vocabulary = described<TriangleMesh>([] {
    using F = Field<TriangleMesh>;
    return schema<TriangleMesh>(
        "mesh",
        {"Triangles: one by one, from a file, or of a solid that is given as an object. Unions, "
         "intersections and differences are then exact; convex_hull { points, objects } is the "
         "smallest convex solid around all.",
         "mesh { triangle { <-1, 0, 0>, <1, 0, 0>, <0, 0.2, -1> } triangle { <-1, 0, 0>, <1, 0, "
         "0>, <0, 1.6, 0.5> } }",
         "mesh { smooth_triangle { <-1, 0, 0>, <-1, 0, -1>, <1, 0, 0>, <1, 0, -1>, <0, 1.6, 0>, "
         "<0, 1, -1> } inside_vector y }",
         "mesh { difference { box { -0.9, 0.9 } sphere { 0, 1.15 } } rotate 25*y translate 0.9*y }",
         "mesh { convex_hull { 1.8*y, box { <-1, 0, -1>, <1, 0.6, 1> } } rotate 25*y }",
         "mesh { sphere { y, 1 } resolution 12 }",
         "mesh { box { <-1, 0, -1>, <1, 1.6, 1> } subdivide 2 smooth rotate 25*y }"},
        parts<&TriangleMesh::triangles>("triangle", "a flat triangle"),
        parts<&TriangleMesh::smooth_triangles>("smooth_triangle", "one with normals"),
        F{"inside_vector", &TriangleMesh::inside_vector, item,
          "direction in which to count crossings to tell inside from outside"},
        F{"file", &TriangleMesh::file, item,
          "an OBJ, PLY, STL or OFF file in the place of triangles"},
        F{"resolution", &TriangleMesh::resolution, item,
          "cells along the longest side of each shape of an object; half the sides of what is "
          "round",
          between(4, 512)},
        F{"subdivide", &TriangleMesh::subdivide, item,
          "steps of Loop's rule: each makes four faces of one, and the surface rounder",
          between(0, 8)},
        F{"smooth", &TriangleMesh::smooth, flag,
          "shades it as if it were curved, with normals of the faces around each point"});
});

namespace {

/// Adds the fields that all kinds of triangles share; returns false for triangles without area.
template <class Facet>
bool add(Mesh& mesh, const Facet& facet) {
    const Vec3 across = cross(facet.corner1 - facet.corner2, facet.corner3 - facet.corner2);
    if (across == Vec3(0)) return false;
    const int first = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {facet.corner1, facet.corner2, facet.corner3});
    mesh.faces.push_back({first, first + 1, first + 2});
    mesh.uvs.insert(mesh.uvs.end(), {facet.uv1, facet.uv2, facet.uv3});
    mesh.looks.push_back(facet.looks);
    return true;
}

}  // namespace

std::string problem(const TriangleMesh& mesh) {
    return mesh.triangles.empty() && mesh.smooth_triangles.empty() ? "a `mesh` needs a triangle"
                                                                   : "";
}

BuiltMesh build(const TriangleMesh& mesh) { return build(as_mesh(mesh)); }

Mesh as_mesh(const TriangleMesh& mesh) {
    Mesh result;
    result.inside_vector = mesh.inside_vector;
    // The smooth faces come first.
    for (const SmoothFacet& facet : mesh.smooth_triangles) {
        if (!add(result, facet)) continue;
        const int first = static_cast<int>(result.normals.size());
        result.normals.insert(result.normals.end(), {facet.normal1, facet.normal2, facet.normal3});
        result.normal_faces.push_back({first, first + 1, first + 2});
    }
    for (const FlatFacet& facet : mesh.triangles) add(result, facet);
    const auto none = [](const auto& list, const auto& value) {
        return std::all_of(list.begin(), list.end(),
                           [&](const auto& each) { return each == value; });
    };
    if (none(result.uvs, Vec2(0))) result.uvs.clear();
    if (none(result.looks, Face{-1, -1, -1})) result.looks.clear();
    return result;
}

}  // namespace candelabra
