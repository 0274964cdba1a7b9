// SPDX-License-Identifier: GPL-3.0-or-later
// Light that comes from between surfaces: what participating media emit along a part of a path, and
// what they scatter to the viewer of the light of all lamps.
#pragma once

#include "medium/march.h"
#include "transport/direct_light.h"
#include "transport/light_left.h"
#include "transport/path.h"

namespace candelabra {

/// One for each job: it keeps scratch memory.
class ParticipatingMedia {
public:
    /// The world outlives it.
    explicit ParticipatingMedia(const World&);

    /// What media make of the radiance that comes along the path's ray from so far, which may be
    /// infinite; an unbiased estimate. `PathState::media` says where the ray is. As in POV-Ray,
    /// media in solids do not show on a part of a path without an end.
    Veil along(const PathState&, double distance, DirectLight&, LightLedger&);

    /// What scatters light again and again along the last stretch, on the scale of transmittance:
    /// the chance that a path is scattered there is weighed by it. 0: nothing does.
    double multiple_scattering() const;
    /// The path that goes on from a point of the last stretch, as media scatter light to the
    /// viewer, with that in its throughput. Each order after the first sends on a quarter of what
    /// POV-Ray's unit of light would, so that no energy is made: an isotropic medium whose
    /// extinction is 1 has an albedo of 1. Precondition: multiple_scattering() is above 0.
    PathState scattered_path(const PathState&) const;

private:
    /// Chooses places by what is expected(index) of them; calls use(place, number of the choice,
    /// one over the expected number of times that the place is chosen).
    template <class Expected, class Use>
    void choose(const Key&, int count, Expected expected, Use use);
    void fill(const PathState&, double distance);
    double near(const Vec3& from) const;
    Vec3 scattered(const PathState&, DirectLight&, LightLedger&);
    double unshadowed(const Vec3& position) const;
    void expect_light(const DirectLight&, std::span<const Vec3> places,
                      std::span<double> worth) const;
    double luminaires_at(const DirectLight&, const Vec3& position) const;

    const World& world_;
    std::vector<std::uint32_t> sources_;  ///< that tell where light is bright, when they are few
    bool lights_all_ = true;              ///< light sources are asked at all places
    int places_ = 0;                      ///< the effort that the last stretch is worth
    // Kept from stretch to stretch for their memory.
    MediaList media_;
    MediaMarch march_;
    std::vector<double> sums_;  ///< running sums of what is expected of the places
};

}  // namespace candelabra
