// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of a path that all integrators share: its start, its continuation from a surface, and
// the background.
#pragma once

#include "base/rgb.h"
#include "transport/light_ledger.h"
#include "transport/path.h"
#include "transport/vertex.h"
#include "world/shot.h"

#include <algorithm>
#include <optional>

namespace candelabra {

/// The two ends of a job's paths: the camera and the sky. It also measures how clear a sample is.
class PathEnds {
public:
    /// `clear_sky`: the background may be clear, as with POV-Ray's +UA. `from_anywhere`: rays may
    /// begin at other places than the camera's.
    PathEnds(const Shot&, bool clear_sky, bool from_anywhere);

    /// Starts a path along a camera ray, for a new sample.
    PathState begin(const Ray&, const Key&);
    /// Radiance of the background, which it records.
    Rgb background(const PathState&, LightLedger&);
    /// Fraction of the sample that shows clear background, from 0 to 1.
    double clear() const { return std::min(clear_, 1.0); }

private:
    Rgb seen_behind(const PathState&);
    Rgb sky_behind(const PathState&);  ///< without the sun

    const World& world_;
    bool starts_anywhere_;  ///< the rays have no common origin
    Vec3 origin_;           ///< of the last ray
    MediaStack around_;     ///< the solids that contain it
    bool clear_sky_;
    double clear_ = 0;
};

/// Records what the sample sees of a thing that glows, if it is seen straight from the camera.
void record_glow(LightLedger&, const PathState&, const Rgb& light);

/// Whether the path sees the primitive's emission. It does not if the luminaire was sampled before.
bool shows_emission(const World&, const PathState&, PrimitiveIndex);
/// Factor of the emission that a path sees of a primitive's finishes; 0 if it has been counted, and
/// of `no_primitive`.
double shown_emission(const World&, const PathState&, PrimitiveIndex);

/// Continues the path in the mirror direction. The reflectivity is not in its throughput.
PathState mirrored_path(const PathState&, const Vertex&, const Shading&);

/// The path scattered by microfacets, and the fraction of the radiance along it, which is in its
/// throughput. Nothing if the facets send it into the surface.
struct FacetPath {
    PathState next;
    Rgb share;
};
std::optional<FacetPath> facet_path(const PathState&, const Vertex&, const Shading&);

/// Ratio of the indices of refraction for the path at a surface. Where white light is split,
/// chooses one of its bands at random: the path has its colour from then on, and the mean of all
/// bands is white.
double refraction_ratio(PathState&, const Interface&);

/// Continues the path behind the surface, into the solids behind the interface, with that ratio of
/// the indices of refraction. As in POV-Ray, a ray that goes straight on takes no level.
/// Precondition: no total reflection.
PathState path_behind(const PathState&, const Vertex&, const Shading&, const Interface&,
                      double ratio);

/// The path scattered by media at a point between surfaces. What it has taken is not changed.
PathState path_from_air(const PathState&, const Vec3& position, const Vec3& direction);

/// The path that gathers light at a diffuse surface from a direction.
PathState gathering_path(const PathState&, const Vertex&, const Vec3& direction);
/// The same from a direction behind the surface: it is in what the surface bounds, if light passes.
PathState gathering_path_behind(const World&, const PathState&, const Vertex&,
                                const Vec3& direction);

}  // namespace candelabra
