// SPDX-License-Identifier: GPL-3.0-or-later
// Light from between surfaces: emission of participating media along a segment of a path, and light
// of all lamps that they scatter to the viewer.
#pragma once

#include "base/rgb.h"
#include "medium/march.h"
#include "transport/direct_light.h"
#include "transport/light_left.h"
#include "transport/path.h"
#include "transport/reflected_light.h"

#include <cstddef>

namespace candelabra {

/// Each job has its own: it keeps scratch memory.
class ParticipatingMedia {
public:
    /// The shot must outlive this.
    explicit ParticipatingMedia(const Shot&);

    /// Transmittance and added radiance of media along the path's ray, up to a distance that may be
    /// infinite; an unbiased estimate. `PathState::media` says where the ray is. As in POV-Ray,
    /// media in solids do not show on an infinite segment. `reflected`: light media as well; null:
    /// none do. `reflections`: after which their light counts, at most.
    Veil along(const PathState&, double distance, DirectLight&, LightLedger&,
               ReflectedLight* reflected = nullptr, int reflections = 0);

    /// Amount of scattering along the last segment, on the scale of transmittance: the weight of
    /// scattering the path there. 0: none. `others`: whether there is light that reflected
    /// luminaires do not stand for, so that a path in search of it counts.
    double scattering(bool others) const;
    /// Continues the path from a point of the last segment, scattered by the media; the scattering
    /// is part of the throughput, in the unit in which media scatter the light of lamps.
    /// Precondition: scattering(others) > 0.
    PathState scattered_path(const PathState&, bool others) const;

private:
    /// Chooses places in proportion to expected(index). Calls use(index, number of the choice, one
    /// over the expected number of times that the place is chosen).
    template <class Expected, class Use>
    void choose(const Key&, int count, Expected expected, Use use);
    void find_taken(const PathState&, const ReflectedLight*);
    double brightness(std::size_t place, bool others) const;
    void fill(const PathState&, double distance);
    bool shows(const PathState&, std::size_t number, const Vec3& point) const;
    double near(const Vec3& from) const;
    Rgb scattered(const PathState&, DirectLight&, LightLedger&);
    Rgb reflected(const PathState&, ReflectedLight&, int reflections, LightLedger&);
    double unshadowed(const Vec3& position) const;
    void expect_light(const DirectLight&, std::span<const Vec3> places,
                      std::span<double> worth) const;
    double choice_at(const DirectLight&, const Vec3& position) const;

    const World& world_;
    const Box& near_;                     ///< see Shot
    std::vector<std::uint32_t> sources_;  ///< that show where light is bright, if they are few
    bool lights_all_ = true;              ///< light sources are sampled at all places
    bool joined_ = false;                 ///< see Shot
    bool has_other_sources_ = false;      ///< than those that are joined
    bool chooses_ = false;                ///< there are lights that the shot's strategy may choose
    int places_ = 0;                      ///< number of places for the last segment
    LightInAir light_ = LightInAir::any;  ///< what the last segment may scatter
    // Kept as members to reuse their memory.
    MediaList media_;
    MediaMarch march_;
    std::vector<double> sums_;  ///< running sums of the places' expected values
    /// Fraction of the light at each place that reflected luminaires have not taken.
    ShortList<double, 64> open_;
    bool reflects_ = false;  ///< reflected luminaires light the places
};

}  // namespace candelabra
