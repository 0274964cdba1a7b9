// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of each way of following light: part of the scene, chosen by global_settings {
// integrator { ... } } or --integrator. They stand apart from the integrators themselves, which
// need a world.
#pragma once

#include "vocabulary/kinds.h"

namespace candelabra {

/// POV-Ray's: all reflections and refractions of a ray, and light that comes straight from lights.
struct PovRay {
    static const ItemInfo vocabulary;
};
/// One path for each sample, which goes on from surface to surface: indirect light counts, too.
struct PathTraced {
    int bounces = 8;
    int reflected_luminaires = 5000;

    static const ItemInfo vocabulary;
};
/// Every integrator there is; the first one is the default.
using IntegratorSettings = std::variant<PovRay, PathTraced>;

}  // namespace candelabra
