// SPDX-License-Identifier: GPL-3.0-or-later
// Decides which unions are stored once and placed as instances: those that a scene places often
// enough to matter, and whose look moves with them. Used by flatten().
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <unordered_map>

namespace candelabra {

struct Inherited;
struct Material;

/// Rays find primitives a little faster than those of an instance, and what only a few places share
/// is taken apart in each of them.
struct InstanceLimits {
    std::size_t least_parts = 16;        ///< of a union
    std::size_t most_parts = 1 << 16;    ///< of larger unions, the unions in them are shared
    std::size_t least_in_all = 1 << 18;  ///< parts in all places together
};

class InstancePlan {
public:
    /// Counts the places of the scene's unions. The scene must outlive this.
    InstancePlan(const Scene&, const InstanceLimits&);

    /// Whether the union is to be stored once. False for those whose look depends on their place.
    bool shares(const Object& object) const {
        const auto found = places_.find(&object);
        return found != places_.end() && found->second.shared;
    }

    /// Whether a texture moves with its object wherever that is.
    static bool is_alike(const Texture&);
    /// The same for surfaces of a material.
    static bool is_alike(const Material&);
    /// Whether nothing is inherited that may differ from one place of an object to the next, except
    /// for such a texture, which looks the same at all points.
    static bool is_bare(const Inherited&);

private:
    struct Places {
        std::size_t count = 0;
        bool shared = false;
    };
    void count(const Object&);

    InstanceLimits limits_;
    std::unordered_map<const Object*, Places> places_;  ///< of unions that are large enough
};

}  // namespace candelabra
