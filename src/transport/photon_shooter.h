// SPDX-License-Identifier: GPL-3.0-or-later
// Photons where they leave lamps: which lamp shoots at which target, and a ray from it to there,
// with its density. Light sources are weighed by what reaches a target. Of luminaires the light
// strategy chooses one, for the middle of a ball around the target: so it knows of ten thousand
// lamps those that light a glass. A ray from it into the ball has the density of the point where it
// enters, times that of the point that the luminaire draws for that one.
#pragma once

#include "base/random.h"
#include "world/world.h"

#include <optional>
#include <vector>

namespace candelabra {

/// A photon on its way to a target.
struct PhotonShot {
    Ray ray;
    double tolerance = 0;      ///< of its start
    std::uint32_t target = 0;  ///< in World::photon_targets, counted from 1
    PhotonWays lamp = {};      ///< what its lamp says of photons
    bool glows = false;        ///< the lamp is a luminaire
    std::uint32_t statement = 0;
    Vec3 power = Vec3(0);  ///< of a luminaire: colour of light times area
    /// Of a light source: steradians, or area if all of its light is parallel.
    double extent = 0;
    const PointLight* source = nullptr;
    Vec3 place = Vec3(0);  ///< of the source: the light of its grid that it comes from

    /// Colour of light times area, after so long a way. Light of a source does not fade unless it
    /// says so: what lies in so many steradians gets stronger with the square of the way.
    Vec3 power_after(double way) const;
};

class PhotonShooter {
public:
    explicit PhotonShooter(const World&);

    /// Lamps that shoot at a target.
    struct Aim {
        enum Kind : std::uint8_t {
            source,      ///< one of POV-Ray's
            luminaires,  ///< all that are outside of the ball around the target
            inner        ///< one that is in the ball, or partly
        };
        Kind kind = source;
        std::uint32_t lamp = 0;    ///< of a source and an inner one
        std::uint32_t target = 0;  ///< in World::photon_targets
        double weight = 0;         ///< colour of light times area, roughly
        double until = 0;          ///< sum of all weights up to this one
    };
    const std::vector<Aim>& aims() const { return aims_; }
    double weight() const { return aims_.empty() ? 0 : aims_.back().until; }

    /// How many photons the scene asks for at a time.
    std::uint32_t count() const;

    /// A photon of an aim. The power of many, divided by their number, is an unbiased estimate of
    /// what the lamps send to the target. Nothing where the drawn ray carries none.
    std::optional<PhotonShot> shoot(const Aim&, const Key&) const;

private:
    void add(Aim);
    void aim_sources(std::uint32_t target);
    void aim_luminaires(std::uint32_t target);
    std::optional<PhotonShot> from_point(const PointLight&, const PhotonTarget&, PhotonShot,
                                         const Key&) const;
    std::optional<PhotonShot> from_plane(const PointLight&, const PhotonTarget&, PhotonShot,
                                         const Key&) const;
    std::optional<PhotonShot> from_luminaires(const PhotonTarget&, PhotonShot, const Key&) const;
    std::optional<PhotonShot> from_inside(LightIndex, const PhotonTarget&, PhotonShot,
                                          const Key&) const;

    const World& world_;
    std::vector<Aim> aims_;
};

}  // namespace candelabra
