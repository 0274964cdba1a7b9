// SPDX-License-Identifier: GPL-3.0-or-later
// The state of a path from the camera: its next ray, and the properties of the path so far.
#pragma once

#include "base/random.h"
#include "base/rgb.h"
#include "surface/dispersion.h"
#include "transport/media_stack.h"
#include "transport/taken.h"

#include <algorithm>
#include <optional>

namespace candelabra {

struct PathState {
    Ray ray;               ///< its direction is a unit vector
    double tolerance = 0;  ///< nearer hits do not count
    /// Factor on the radiance along the ray in the sample. 0 where the sample is not proportional
    /// to that radiance.
    Rgb throughput = Rgb(1);
    /// The same for light from behind the whole scene, for the picture's alpha: as in POV-Ray, only
    /// the grey of each surface's colour counts.
    double clear = 1;
    int depth = 0;    ///< number of reflections and refractions so far
    int bounces = 0;  ///< number of diffuse reflections
    /// Surfaces passed without a change of direction, which `depth` does not include.
    int passed = 0;
    /// Greatest change of the pixel that the ray can make, relative to the ray's radiance:
    /// POV-Ray's criterion for termination.
    double weight = 1;
    RayKind kind = RayKind::camera;
    Key key;
    MediaStack media;
    std::optional<SpectralBand> band;  ///< if the ray is one colour of split white light
    Taken taken;                       ///< by other estimates, of the light along the ray
    /// Whether a medium without `multiple` has scattered the path, which only one of them does.
    bool scattered = false;

    /// Returns the same path with its throughput multiplied by `share`.
    PathState dimmed(const Rgb& share) const {
        PathState result = *this;
        result.dim(share);
        return result;
    }
    void dim(const Rgb& share) {
        throughput *= share;
        clear *= std::min(1.0, std::abs(grey(share)));
    }

    /// Continues from a surface along the ray, one level deeper.
    void go_on(const Ray& next, double min_distance, Branch branch) {
        ray = next;
        tolerance = min_distance;
        ++depth;
        key = key.branched(branch);
    }
};

}  // namespace candelabra
