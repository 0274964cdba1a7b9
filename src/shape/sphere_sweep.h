// SPDX-License-Identifier: GPL-3.0-or-later
// The solid swept by a sphere that moves along a curve and changes its radius. Rays are tested
// against the BuiltSphereSweep.
#pragma once

#include "base/ray.h"
#include "shape/part_index.h"
#include "vocabulary/item_info.h"

namespace candelabra {

enum SweepWay : int {
    no_way = -1,
    linear_way,  ///< straight from sphere to sphere
    cubic_way,   ///< through all spheres but the first and the last (Catmull and Rom)
    b_way,       ///< near the spheres, smoother than the other ways
};

struct SphereSweep {
    int spline = no_way;
    std::vector<Ball> spheres;
    double tolerance = 1e-6;

    static const ItemInfo vocabulary;
};

struct BuiltSphereSweep {
    /// centre(u) = centres[0] + centres[1] u + ... for u from 0 to 1, and the radius likewise.
    struct Piece {
        std::array<Vec3, 4> centres;
        std::array<double, 4> radii;

        Vec3 centre(double u) const {
            return centres[0] + u * (centres[1] + u * (centres[2] + u * centres[3]));
        }
        double radius(double u) const {
            return radii[0] + u * (radii[1] + u * (radii[2] + u * radii[3]));
        }
    };
    std::vector<Piece> pieces;
    PartIndex index;
};

BuiltSphereSweep build(const SphereSweep&, const RayIndex& = {});
/// Error that the ranges of single fields do not exclude (no kind of spline, too few spheres), as a
/// sentence; empty when there is none.
std::string problem(const SphereSweep&);
/// See shape.h.
std::string vanishes(const SphereSweep&);

Box bounds(const BuiltSphereSweep&);
void crossings(const BuiltSphereSweep&, const Ray&, Crossings&);
bool inside(const BuiltSphereSweep&, const Vec3&);

}  // namespace candelabra
