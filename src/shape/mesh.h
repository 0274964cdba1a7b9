// SPDX-License-Identifier: GPL-3.0-or-later
// Triangle meshes: vertices stored once, faces by index. The world takes them apart into triangles.
#pragma once

#include "base/ray.h"
#include "vocabulary/item_info.h"

/// Triangles over shared vertices (POV-Ray's mesh2). Without an inside_vector, or with one of
/// length 0, it has no inside.
struct Mesh {
    std::vector<Vec3> vertices;
    std::vector<Vec3> normals;
    std::vector<Face> faces;
    std::vector<Face>
        normal_faces;  ///< empty: the faces' own indices when there is a normal for each vertex
    std::vector<Vec2> uvs;
    std::vector<Face> uv_faces;  ///< empty: the faces' own indices
    std::vector<Face> looks;     ///< numbers of the textures of each face's corners, -1 for none;
                                 ///< empty: no face has any
    std::optional<Vec3> inside_vector;

    static const ItemInfo vocabulary;
};

/// What is wrong with the lists (an index out of range, too many normals ...), as a sentence; empty
/// when nothing is.
std::string problem(const Mesh&);

/// Face number i as a triangle with its unit normals. Where the mesh has none, or one of length 0,
/// it is the face's own. Faces without area are allowed, as modellers write them: their own normal
/// is 0, and no ray meets them.
struct MeshTriangle {
    std::array<Vec3, 3> corners;
    std::array<Vec3, 3> normals;
    bool smooth;
};
/// Precondition: problem() is empty.
MeshTriangle face(const Mesh&, std::size_t i);

Box bounds(const Mesh&);
void crossings(const Mesh&, const Ray&, Crossings&);
bool inside(const Mesh&, const Vec3&);
