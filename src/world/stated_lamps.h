// SPDX-License-Identifier: GPL-3.0-or-later
// Lamps whose flux the scene states. Their radiance follows when all of their surfaces are
// in place.
// Used by flatten().
#pragma once

#include "text/diagnostic.h"
#include "world/world.h"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace candelabra {

class StatedLamps {
public:
    /// Begins a lamp: an object in its place. Returns its number, from 1.
    std::uint32_t begin(const Handle<LampData>&, const Handle<Transform>& place, Span);

    /// Adds a glowing primitive to a lamp; 0: to none. `sealed`: see lit_surface().
    void add(std::uint32_t lamp, PrimitiveKind kind, std::size_t index, bool sealed);

    /// Sets Appearance::outputs and output_of. Precondition: the primitives and their materials are
    /// complete.
    void settle(World&, Diagnostics&) const;

private:
    struct Lamp {
        Handle<LampData> data;
        Handle<Transform> place;  ///< of the object; null: none
        Span span;
    };
    struct Part {
        std::uint32_t lamp;
        PrimitiveKind kind;
        std::uint32_t index;
        bool sealed;
    };

    std::vector<Lamp> lamps_;
    std::vector<Part> parts_;  ///< those of a lamp one after the other
};

}  // namespace candelabra
