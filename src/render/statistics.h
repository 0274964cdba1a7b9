// SPDX-License-Identifier: GPL-3.0-or-later
// What a rendering cost, in rays.
#pragma once

#include "base/exact_sum.h"
#include "base/vector.h"

#include <cstdint>
#include <vector>

/// What lights of one statement of the scene gave and cost.
struct LightCount {
    ExactSum light;          ///< grey, that came from them to all hits and on to who looks at these
    std::uint64_t rays = 0;  ///< towards them
    /// What of them came to the camera in samples that nobody has taken yet (Tracer::take_lights).
    Vec3 seen = Vec3(0);
};

struct RayCounts {
    std::uint64_t camera = 0;
    std::uint64_t shadow = 0;     ///< towards luminaires and light sources
    std::uint64_t scattered = 0;  ///< reflected and refracted
    /// For each of Provenance::light_statements, and at the end for rays that met no luminaire.
    /// Empty when nobody asks.
    std::vector<LightCount> lights = {};
    /// Of the radiance that is asked for at the moment, in the sample that it is asked for.
    Vec3 share = Vec3(1);
    /// And of what is clear behind it, as POV-Ray counts it: of each surface's colour only the
    /// grey.
    double clear = 1;

    RayCounts& operator+=(const RayCounts& other) {
        camera += other.camera;
        shadow += other.shadow;
        scattered += other.scattered;
        if (lights.size() < other.lights.size()) lights.resize(other.lights.size());
        for (std::size_t i = 0; i < other.lights.size(); ++i) {
            lights[i].light.add(other.lights[i].light);
            lights[i].rays += other.lights[i].rays;
        }
        return *this;
    }
};
