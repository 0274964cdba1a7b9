// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh whose triangles are written one by one, each with its corners: POV-Ray's `mesh`. It is
// built as the Mesh that `mesh2` describes. Meshes that come from a file or an object are not built
// here: the reader of the scene does that, and replaces this shape by a Mesh.
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

/// A triangle of a mesh, with normals at its corners.
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
    // Fields of meshes that are not given as triangles.
    std::string file;
    int resolution = 64;
    int subdivide = 0;
    bool smooth = false;

    static const ItemInfo vocabulary;
};

/// Error that the ranges of single fields do not exclude (no triangle), as a sentence; empty when
/// there is none.
std::string problem(const TriangleMesh&);
Mesh as_mesh(const TriangleMesh&);
BuiltMesh build(const TriangleMesh&);

}  // namespace candelabra
