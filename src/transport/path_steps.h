// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of a path that are the same for all integrators: where it begins, how it goes on from a
// surface, and what lies behind everything.
#pragma once

#include "transport/path.h"
#include "transport/vertex.h"

#include <algorithm>
#include <optional>

namespace candelabra {

/// Both ends of the paths of one job: the camera, and the sky. It knows how clear a sample is.
class PathEnds {
public:
    /// `clear_sky`: what is behind everything may be clear, as in POV-Ray's +UA.
    PathEnds(const World&, bool clear_sky);

    /// A path along a camera ray, for a new sample.
    PathState begin(const Ray&, const Key&);
    /// Radiance from behind everything.
    Vec3 background(const PathState&);
    /// How much of the sample is what is behind everything and clear: 0 to 1.
    double clear() const { return std::min(clear_, 1.0); }

private:
    const World& world_;
    MediaStack around_camera_;
    bool clear_sky_;
    double clear_ = 0;
};

/// Whether the primitive's emission is part of what the path sees. It is not where the luminaire
/// was asked for its light before.
bool shows_emission(const World&, const PathState&, PrimitiveIndex);

/// The path that goes on as a mirror sends it. What is reflected is not in its throughput.
PathState mirrored_path(const PathState&, const Vertex&, const Shading&);

/// The path that goes on as small facets scatter it, and the share of the radiance along it, which
/// is in its throughput. Nothing when they send it into the surface.
struct FacetPath {
    PathState next;
    Vec3 share;
};
std::optional<FacetPath> facet_path(const PathState&, const Vertex&, const Shading&);

/// The ratio of indexes of refraction for the path at a surface. Of the bands of white light, where
/// it is split, chance takes one, whose colour the path has from then on: as all of them together
/// have its mean.
double refraction_ratio(PathState&, const Interface&);

/// The path that gathers the light which comes to a diffuse surface from a direction.
PathState gathering_path(const PathState&, const Vertex&, const Vec3& direction);

}  // namespace candelabra
