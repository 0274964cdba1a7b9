// SPDX-License-Identifier: GPL-3.0-or-later
// The surfaces that many instances share: see Instance (world/geometry.h). A union of a thousand
// lamps that stands in ten thousand places is stored once, and each place takes some bytes more.
#pragma once

#include "lighting/light_tree.h"
#include "luminaire/luminaire.h"
#include "world/geometry.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace candelabra {

/// Surfaces and luminaires in the space of a declared object, before it is placed. They are
/// bounded, and their look moves with them.
struct Prototype {
    std::size_t primitive_count() const { return material_of.size(); }
    /// A number for the solid that a triangle belongs to: that of its first triangle.
    PrimitiveIndex first_of_solid(PrimitiveIndex triangle) const {
        return first_of_solids.empty() ? triangle
                                       : first_of_solids[triangle - geometry.triangles_begin()];
    }

    Geometry geometry;                       ///< without instances
    Box box;                                 ///< around all of it
    std::vector<std::uint32_t> material_of;  ///< per primitive, in Appearance::materials
    bool blocks_light = true;                ///< whether every surface stops shadow rays
    bool clear = false;                      ///< whether light can pass through some surface
    bool has_interiors = false;              ///< whether some solid has one, or is clear
    /// Per triangle: the first one of its mesh; empty if none is clear.
    std::vector<PrimitiveIndex> first_of_solids;
    std::vector<Luminaire> luminaires;       ///< each of them can be placed: see luminaire/placed.h
    /// Per primitive: index in luminaires, or no_primitive; empty if there are none.
    std::vector<std::uint32_t> luminaire_of;
    LightTree lights;              ///< of the luminaires
    double luminance = 0;          ///< of the brightest of them
    std::size_t object_count = 0;  ///< as the scene counts them
};

}  // namespace candelabra
