// SPDX-License-Identifier: GPL-3.0-or-later
// light_source blocks. Called for the elements of a scene, for #declare, and by the readers of
// objects.
#pragma once

#include "evaluate/bind.h"
#include "scene/scene.h"

/// Nothing after a report.
std::optional<PlacedLight> read_light(Binder&, const Element& block);
