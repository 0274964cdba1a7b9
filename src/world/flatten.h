// SPDX-License-Identifier: GPL-3.0-or-later
// Takes a scene's objects apart into the primitives of a world, with everything they inherit from
// their unions.
#pragma once

#include "text/diagnostic.h"
#include "world/world.h"

namespace candelabra {

enum class Flatten {
    everything,
    luminaires,  ///< of other objects only their number and their materials
};

/// Fills the world's primitives, materials and luminaires, and Provenance::object_of if that is
/// wanted.
void flatten(const Scene&, World&, Diagnostics&, Flatten = Flatten::everything,
             bool remembers_objects = false);

}  // namespace candelabra
