// SPDX-License-Identifier: GPL-3.0-or-later
// The surface where a function of x, y, z has a given value, within a box or a sphere. Functions
// written in the scene are searched by interval arithmetic, which misses no crossing; for others
// the scene's max_gradient is trusted. Rays are tested against the BuiltIsosurface.
#pragma once

#include "formula/formula.h"
#include "shape/box.h"
#include "shape/sphere.h"

namespace candelabra {

/// The box or sphere that cuts off an isosurface or a parametric surface.
struct Container {
    std::vector<Cuboid> boxes;
    std::vector<Sphere> spheres;

    static const ItemInfo vocabulary;
};

using ContainerShape = std::variant<Cuboid, Sphere>;
/// Returns the last container given; a box from -1 to 1 when there is none.
ContainerShape container_shape(const std::vector<Container>&);

struct Isosurface {
    Handle<Formula> function;
    std::vector<Container> containers;
    double threshold = 0;
    double polarity = -1;  ///< above 0: inside it is higher
    double accuracy = 0.001;
    double max_gradient = 1.1;
    double evaluate1 = 0, evaluate2 = 0, evaluate3 = 0;
    int max_trace = 1;
    bool all_intersections = false;
    bool open = false;

    static const ItemInfo vocabulary;
};

struct BuiltIsosurface {
    Handle<Formula> function;
    ContainerShape container;
    double threshold = 0, accuracy = 0, max_gradient = 0;
    bool open = false;
    bool inside_is_higher = false;
};

/// Error that the ranges of single fields do not exclude (no function, or one with other
/// parameters), as a sentence; empty when there is none.
std::string problem(const Isosurface&);
BuiltIsosurface build(const Isosurface&);

Box bounds(const BuiltIsosurface&);
/// See crossings_in() of BuiltShape.
void crossings_between(const BuiltIsosurface&, const Ray&, const Interval& range, Crossings&);
void nearest_crossings(const BuiltIsosurface&, const Ray&, const Interval& range, Crossings&);
void crossings(const BuiltIsosurface&, const Ray&, Crossings&);
bool inside(const BuiltIsosurface&, const Vec3&);

}  // namespace candelabra
