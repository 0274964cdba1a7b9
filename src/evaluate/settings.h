// SPDX-License-Identifier: GPL-3.0-or-later
// global_settings and background blocks. Called for the elements of a scene.
#pragma once

#include "evaluate/bind.h"
#include "scene/scene.h"

/// What the block says is added to the settings. `gamma_given`: whether a block has said
/// assumed_gamma.
void read_global_settings(Binder&, const Element& block, GlobalSettings&, bool& gamma_given);
void read_background(Binder&, const Element& block, Background&);
