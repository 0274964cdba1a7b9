// SPDX-License-Identifier: GPL-3.0-or-later
// global_settings blocks. Called for the elements of a scene.
#pragma once

#include "bind/bind.h"
#include "scene/scene.h"

namespace candelabra {

/// What any block of settings has said: other things depend on it.
struct GivenSettings {
    bool gamma = false;
};

/// What the block says is added to the settings.
void read_global_settings(Binder&, const Element& block, GlobalSettings&, GivenSettings& before);

}  // namespace candelabra
