// SPDX-License-Identifier: GPL-3.0-or-later
// The lamps of a world as the list by which a file keeps their light.
#pragma once

#include "relight/lamp_list.h"
#include "world/world.h"

#include <cstdint>
#include <string>
#include <vector>

namespace candelabra {

struct WorldLamps {
    LampList list;
    /// Places in the list.
    std::vector<std::uint32_t> of_luminaire, of_source;
    std::uint32_t of_sky = 0;

    std::uint32_t place_of(Lamp lamp) const {
        if (lamp.is_sky()) return of_sky;
        return (lamp.is_source() ? of_source : of_luminaire)[lamp.index()];
    }
};

/// `names`: of each of Provenance::light_statements. The lamps of a statement are numbered as the
/// world does: luminaires, then light sources, then the sky.
WorldLamps world_lamps(const World&, const std::vector<std::string>& names);

}  // namespace candelabra
