// SPDX-License-Identifier: GPL-3.0-or-later
// Triangle meshes: vertices stored once, faces by index. The world splits most of them into single
// triangles; copies, composites and the functions of the language use the BuiltMesh.
#pragma once

#include "base/handle.h"
#include "base/ray.h"
#include "shape/part_index.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// Triangles over shared vertices (POV-Ray's mesh2). Without an inside_vector, or with one of
/// length 0, it has no inside.
struct Mesh {
    std::vector<Vec3> vertices;
    std::vector<Vec3> normals;
    std::vector<Face> faces;
    /// Empty: the faces' own indices are used when there is a normal for each vertex.
    std::vector<Face> normal_faces;
    std::vector<Vec2> uvs;
    std::vector<Face> uv_faces;  ///< empty: the faces' own indices
    std::vector<Face> looks;     ///< texture numbers of the faces' corners, -1: none; empty: all
                                 ///< none
    std::optional<Vec3> inside_vector;

    static const ItemInfo vocabulary;
};

/// Error in the lists (an index out of range, too many normals ...), as a sentence; empty when
/// there is none.
std::string problem(const Mesh&);

/// Face number i as a triangle with its unit normals. Where the mesh has no normal, or one of
/// length 0, the face's own is used. Faces without area are allowed, since modellers write them:
/// their own normal is 0, and no ray hits them.
struct MeshTriangle {
    std::array<Vec3, 3> corners;
    std::array<Vec3, 3> normals;
    bool smooth;
};
/// Precondition: problem() is empty.
MeshTriangle face(const Mesh&, std::size_t i);

/// Texture coordinates of the corners of face number i; 0 where the mesh has none.
std::array<Vec2, 3> face_uvs(const Mesh&, std::size_t i);

class MeshArea;

/// A mesh in the form for ray tests, when it is not split into triangles. The part of a crossing is
/// the face.
struct BuiltMesh {
    Handle<Mesh> mesh;
    PartIndex index;  ///< over the faces
    Handle<MeshArea> area;
};
BuiltMesh build(const Mesh&, const RayIndex& = {});

Box bounds(const BuiltMesh&);
void crossings(const BuiltMesh&, const Ray&, Crossings&);
/// Finds the first crossing in the range, and possibly others.
void nearest_crossings(const BuiltMesh&, const Ray&, const Interval& range, Crossings&);
bool inside(const BuiltMesh&, const Vec3&);

}  // namespace candelabra
