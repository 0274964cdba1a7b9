// SPDX-License-Identifier: GPL-3.0-or-later
// What flatten() knows of primitives beside their geometry until it knows all of them: primitives
// are numbered by kind, so each kind is kept separately.
#pragma once

#include "world/emitters.h"
#include "world/material.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace candelabra {

/// A surface whose parts have textures of their own.
struct Parted {
    PrimitiveKind kind;
    std::uint32_t index;
    TextureList textures;
};

/// What is known of primitives beside their geometry, until all of them are known.
struct PrimitiveLists {
    /// Numbers the leaves. Returns the materials of all primitives in their order.
    std::vector<std::uint32_t> materials_in_order(Geometry& geometry) {
        std::vector<std::uint32_t> all = std::move(sphere_materials_);
        all.reserve(all.size() + triangle_materials_.size() + shape_materials_.size() +
                    leaf_materials_.size());
        for (const auto* more : {&triangle_materials_, &shape_materials_, &leaf_materials_})
            all.insert(all.end(), more->begin(), more->end());
        if (!geometry.normals.empty())
            geometry.normals_of.resize(geometry.triangles.size(), no_primitive);
        const PrimitiveIndex leaves = geometry.leaves_begin();
        for (PlacedComposite& placed : geometry.composites) placed.first_leaf += leaves;
        return all;
    }

    std::vector<std::uint32_t> sphere_materials_, triangle_materials_, shape_materials_,
        leaf_materials_;
    std::vector<Span> leaf_spans_;
    std::vector<std::uint32_t> leaf_lamps_;
    std::vector<GlowingPrimitive> glowing_;  ///< surfaces
    std::vector<GlowingPrimitive> filled_;   ///< with media that light the scene
    std::vector<Parted> parted_;
    bool clear_triangle_ = false;  ///< whether a triangle that is no mesh's face is transparent
};

}  // namespace candelabra
