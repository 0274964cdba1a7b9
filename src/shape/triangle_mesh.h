// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh whose triangles are written one by one, each with its corners: POV-Ray's `mesh`. It is
// built as the Mesh that `mesh2` describes. What is made of a file or an object is not built here:
// whoever reads the scene does that, and puts a Mesh in its place.
#pragma once

#include "shape/mesh.h"

namespace candelabra {

/// A triangle of a mesh; `looks` are the numbers of its corners' textures, -1 for none.
struct FlatFacet {
    Vec3 corner1 = Vec3(0), corner2 = Vec3(1, 0, 0), corner3 = Vec3(0, 1, 0);
    Vec2 uv1 = Vec2(0), uv2 = Vec2(0), uv3 = Vec2(0);
    Face looks{-1, -1, -1};

    static const ItemInfo vocabulary;
};

/// The same with normals of its corners.
struct SmoothFacet {
    Vec3 corner1 = Vec3(0), normal1 = Vec3(0, 0, 1);
    Vec3 corner2 = Vec3(1, 0, 0), normal2 = Vec3(0, 0, 1);
    Vec3 corner3 = Vec3(0, 1, 0), normal3 = Vec3(0, 0, 1);
    Vec2 uv1 = Vec2(0), uv2 = Vec2(0), uv3 = Vec2(0);
    Face looks{-1, -1, -1};

    static const ItemInfo vocabulary;
};

struct TriangleMesh {
    std::vector<FlatFacet> triangles;
    std::vector<SmoothFacet> smooth_triangles;
    std::optional<Vec3> inside_vector;
    // Of what is made in the place of triangles.
    std::string file;
    int resolution = 64;
    int subdivide = 0;
    bool smooth = false;

    static const ItemInfo vocabulary;
};

/// What is wrong beyond the ranges of single fields (no triangle), as a sentence; empty when
/// nothing is.
std::string problem(const TriangleMesh&);
Mesh as_mesh(const TriangleMesh&);
BuiltMesh build(const TriangleMesh&);

}  // namespace candelabra
