// SPDX-License-Identifier: GPL-3.0-or-later
// Takes a scene's objects apart into the primitives of a world, with all attributes that they
// inherit from their unions.
#pragma once

#include "text/diagnostic.h"
#include "world/instance_plan.h"
#include "world/world.h"

namespace candelabra {

enum class Flatten {
    everything,
    luminaires,  ///< other objects only count, by number and materials
};

struct FlattenOptions {
    Flatten what = Flatten::everything;
    bool remembers_objects = false;  ///< whether to fill Provenance::object_of
    bool follows_lamps = false;      ///< keeps luminaires also if no surface shows their light
    InstanceLimits instances = {};   ///< unions that are stored once; not if objects are remembered
};

/// Fills the world's primitives, materials and luminaires.
void flatten(const Scene&, World&, Diagnostics&, const FlattenOptions&);

}  // namespace candelabra
