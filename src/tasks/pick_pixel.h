// SPDX-License-Identifier: GPL-3.0-or-later
// `--pick`: prints what is at a pixel, and which lamps light it. Only that pixel is rendered.
#pragma once

#include "tasks/scene_steps.h"

namespace candelabra {

int pick_pixel(SceneSteps&);

}  // namespace candelabra
