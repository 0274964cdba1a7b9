// SPDX-License-Identifier: GPL-3.0-or-later
// Takes a scene's objects apart into the primitives of a world, with all attributes that they
// inherit from their unions.
#pragma once

#include "text/diagnostic.h"
#include "world/world.h"

namespace candelabra {

enum class Flatten {
    everything,
    luminaires,  ///< other objects only count, by number and materials
};

/// Fills the world's primitives, materials and luminaires, and Provenance::object_of if
/// `remembers_objects`.
void flatten(const Scene&, World&, Diagnostics&, Flatten = Flatten::everything,
             bool remembers_objects = false);

}  // namespace candelabra
