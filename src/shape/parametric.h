// SPDX-License-Identifier: GPL-3.0-or-later
// A surface whose points are functions of u and v, within a box or a sphere. It is divided into
// facets; where a ray hits a facet, the point of the surface itself is found. Rays are tested
// against the BuiltParametric.
#pragma once

#include "shape/isosurface.h"
#include "shape/part_index.h"

namespace candelabra {

struct Parametric {
    Handle<Formula> x, y, z;  ///< functions of u, v
    Vec2 first = Vec2(0);     ///< lower bounds of u and v
    Vec2 last = Vec2(0);      ///< upper bounds
    std::vector<Container> containers;
    double accuracy = 0.001;
    double max_gradient = 1;
    int precompute = 0;
    Vec3 precomputed1 = Vec3(0), precomputed2 = Vec3(0), precomputed3 = Vec3(0);

    static const ItemInfo vocabulary;
};

/// A cell of the net of facets, or a part of one where the surface leaves the container for distant
/// points, at a pole of its functions.
struct ParametricPiece {
    Vec2 first, step;             ///< in u and v
    std::array<Vec3, 4> corners;  ///< first u and v; last u; both last; last v

    Vec2 middle() const { return first + 0.5 * step; }
};

struct BuiltParametric {
    std::array<Handle<Formula>, 3> functions;
    Vec2 first = Vec2(0), step = Vec2(0);  ///< of the net in u and v
    std::vector<Vec3> net;                 ///< row by row, u along the rows
    std::vector<Box> net_boxes;            ///< around squares of the net, row by row
    ContainerShape container;
    std::vector<ParametricPiece> pieces;
    PartIndex index;  ///< over the pieces

    Vec3 at(const Vec2& uv) const;
};

/// Error that the ranges of single fields do not exclude (functions of other arguments), as a
/// sentence; empty when there is none.
std::string problem(const Parametric&);
std::string vanishes(const Parametric&);
BuiltParametric build(const Parametric&, const RayIndex& = {});

Box bounds(const BuiltParametric&);
void crossings(const BuiltParametric&, const Ray&, Crossings&);
bool inside(const BuiltParametric&, const Vec3&);

/// u and v of a point of the surface; `part` is the piece that contains it, if known.
Vec2 parameters_at(const BuiltParametric&, const Vec3& point, std::optional<std::uint32_t> part);

}  // namespace candelabra
