// SPDX-License-Identifier: GPL-3.0-or-later
// A curved sheet between 16 control points, taken apart into smooth triangles. Rays ask the
// BuiltBicubicPatch.
#pragma once

#include "base/ray.h"
#include "shape/part_index.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// A Bezier patch of degree 3 by 3. Its points come row by row; u goes across the rows, v along
/// them.
struct BicubicPatch {
    std::vector<Vec3> points;
    int type = -1;
    double flatness = 0;
    int u_steps = 0;
    int v_steps = 0;
    double accuracy = 0.01;
    /// Of the corners: first row's ends, then last row's end and beginning.
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

/// What is wrong beyond the ranges of single fields (no type), as a sentence; empty when nothing
/// is.
std::string problem(const BicubicPatch&);
/// Halves the patch in each direction as often as its steps say, or until its points lie so flat as
/// its flatness says.
BuiltBicubicPatch build(const BicubicPatch&, const RayIndex& = {});

Box bounds(const BuiltBicubicPatch&);
void crossings(const BuiltBicubicPatch&, const Ray&, Crossings&);
bool inside(const BuiltBicubicPatch&, const Vec3&);

}  // namespace candelabra
