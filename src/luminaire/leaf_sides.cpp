// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/leaf_sides.h"

namespace candelabra {

namespace {

/// Distance of points beside the surface as a fraction of the leaf's size.
constexpr double aside = 1e-8;

bool has_unsure_sides(const BuiltMesh&) { return true; }
bool has_unsure_sides(const JuliaFractal&) { return true; }
bool has_unsure_sides(const BuiltHeightField& field) { return field.smooth; }
template <ShapeKind T>
bool has_unsure_sides(const T&) {
    return false;
}

}  // namespace

LeafSides::LeafSides(const Composite& whole, std::uint32_t leaf, double size)
    : whole_(whole),
      beside_(aside * size),
      unsure_(visit_shape([](const auto& shape) { return has_unsure_sides(shape); },
                          whole.leaf(leaf).shape)) {}

bool LeafSides::leaves(const Ray& line, const Composite::Meeting& met) const {
    if (unsure_) {
        const bool before = whole_.inside(line.at(met.t - beside_)),
                   behind = whole_.inside(line.at(met.t + beside_));
        if (before != behind) return before;
    }
    return dot(met.normal, line.direction) > 0;
}

}  // namespace candelabra
