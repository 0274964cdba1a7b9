// SPDX-License-Identifier: GPL-3.0-or-later
// A curved sheet defined by 16 control points, subdivided into smooth triangles. Rays are tested
// against the BuiltBicubicPatch.
#pragma once

#include "base/ray.h"
#include "shape/part_index.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// A bicubic Bezier patch. Its points are stored row by row; u runs across the rows, v along them.
struct BicubicPatch {
    std::vector<Vec3> points;
    int type = -1;
    double flatness = 0;
    int u_steps = 0;
    int v_steps = 0;
    double accuracy = 0.01;
    /// Texture coordinates of the corners: both ends of the first row, then the end and the
    /// beginning of the last row.
    Vec2 uv1 = Vec2(0, 0), uv2 = Vec2(1, 0), uv3 = Vec2(1, 1), uv4 = Vec2(0, 1);

    static const ItemInfo vocabulary;
};

struct BuiltBicubicPatch {
    struct Facet {
        std::array<Vec3, 3> corners, normals;
        std::array<Vec2, 3> uvs;
    };
    std::vector<Facet> facets;
    PartIndex index;
};

/// Error that the ranges of single fields do not exclude (no type), as a sentence; empty when there
/// is none.
std::string problem(const BicubicPatch&);
/// Halves the patch in each direction as many times as its steps say, or until its control points
/// are as flat as its flatness asks.
BuiltBicubicPatch build(const BicubicPatch&, const RayIndex& = {});

Box bounds(const BuiltBicubicPatch&);
void crossings(const BuiltBicubicPatch&, const Ray&, Crossings&);
bool inside(const BuiltBicubicPatch&, const Vec3&);

}  // namespace candelabra
