// SPDX-License-Identifier: GPL-3.0-or-later
// Light that enters a solid at one point of its surface and leaves it at another, as the finish's
// subsurface describes. Called by the integrators in place of diffuse light. Each estimate is
// unbiased for the model: the dipole, and light that is scattered once on its way from a light
// source.
#pragma once

#include "base/rgb.h"
#include "transport/direct_light.h"
#include "transport/path.h"

namespace candelabra {

/// Whether the layer's diffuse light comes from inside the solid.
bool scatters_inside(const World&, const Shading&);

/// Radiance towards the viewer by light from inside the solid that the path has hit. The path's
/// weight, which is the greatest change of the pixel by it, determines the number of samples.
Rgb light_from_inside(const World&, DirectLight&, const LitLayer&, const PathState&, LightLedger&);

}  // namespace candelabra
