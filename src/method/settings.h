// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of each integrator: part of the scene, chosen by global_settings { integrator { ... }
// } or --integrator. Separate from the integrators themselves, which depend on a world.
#pragma once

#include "vocabulary/kinds.h"

#include <optional>

namespace candelabra {

/// POV-Ray's method: all reflections and refractions of a ray, and direct light from the lights.
struct PovRay {
    static const ItemInfo vocabulary;
};
/// Path tracing: one path per sample, which continues from surface to surface and so includes
/// indirect light.
struct PathTraced {
    int bounces = 8;
    std::optional<int> reflected_luminaires;  ///< unset: as many as pay

    static const ItemInfo vocabulary;
};
/// All integrators; the first one is the default.
using IntegratorSettings = std::variant<PovRay, PathTraced>;

}  // namespace candelabra
