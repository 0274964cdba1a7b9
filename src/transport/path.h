// SPDX-License-Identifier: GPL-3.0-or-later
// The state of a path that is followed from the camera: its next ray, and all that is known of the
// way so far.
#pragma once

#include "base/random.h"
#include "surface/dispersion.h"
#include "transport/media_stack.h"

#include <algorithm>
#include <optional>

namespace candelabra {

struct PathState {
    Ray ray;               ///< its direction is a unit vector
    double tolerance = 0;  ///< hits that are nearer do not count
    /// By what radiance that comes along the ray is multiplied in the sample. 0 where the sample is
    /// no multiple of it.
    Vec3 throughput = Vec3(1);
    /// The same for light from behind everything, as POV-Ray counts how clear a picture is: of each
    /// surface's colour only the grey.
    double clear = 1;
    int depth = 0;    ///< reflections and refractions so far
    int bounces = 0;  ///< diffuse ones
    int passed = 0;   ///< surfaces passed without a change of direction, which do not count there
    /// The greatest change of the pixel that the ray can make, relative to its radiance: POV-Ray's
    /// measure of when to stop.
    double weight = 1;
    RayKind kind = RayKind::camera;
    Key key;
    MediaStack media;
    std::optional<SpectralBand> band;  ///< when it is one colour of split white light
    bool collects = false;             ///< photons bring light to the surface that it comes from
    bool brought = false;              ///< and that of the luminaires that it meets
    bool counted = false;  ///< the light of luminaires that it meets has been counted already
    /// Of a ray from a surface that reflected luminaires light: its cosine to the normal there. 0
    /// of others.
    double leaving = 0;
    /// Reflected luminaires have counted the light of luminaires that comes to it by way of diffuse
    /// surfaces only.
    bool covered = false;

    /// The same path where only a share of the radiance comes on to the sample.
    PathState dimmed(const Vec3& share) const {
        PathState result = *this;
        result.dim(share);
        return result;
    }
    void dim(const Vec3& share) {
        throughput *= share;
        clear *= std::min(1.0, std::abs(grey(share)));
    }

    /// Goes on from a surface along the ray, one level deeper.
    void go_on(const Ray& next, double min_distance, Branch branch) {
        ray = next;
        tolerance = min_distance;
        ++depth;
        key = key.branched(branch);
    }
};

}  // namespace candelabra
