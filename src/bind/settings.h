// SPDX-License-Identifier: GPL-3.0-or-later
// Reads global_settings blocks. Called for the elements of a scene.
#pragma once

#include "reading/item_reader.h"
#include "scene/scene.h"

namespace candelabra {

/// Settings given by any block so far, on which other things depend.
struct GivenSettings {
    bool gamma = false;
};

/// Adds the settings of the block to the last two arguments.
void read_global_settings(Binder&, const Element& block, GlobalSettings&, GivenSettings& before);

}  // namespace candelabra
