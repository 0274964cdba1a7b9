// SPDX-License-Identifier: GPL-3.0-or-later
// Emission of photons: which lamp shoots at which target, and a ray from the lamp to the target,
// with its pdf. Light sources are weighted by the light that reaches the target. Among luminaires,
// the light strategy chooses one for the centre of a ball around the target, so that it finds the
// few of ten thousand lamps that light a glass. The pdf of a ray from a luminaire into the ball is
// that of its entry point, times that of the point sampled on the luminaire for that entry point.
#pragma once

#include "base/random.h"
#include "base/rgb.h"
#include "transport/source_rays.h"
#include "world/shot.h"

#include <optional>
#include <vector>

namespace candelabra {

/// A photon on its way to a target.
struct PhotonShot {
    Ray ray;
    double tolerance = 0;      ///< of its start
    std::uint32_t target = 0;  ///< in World::photon_targets, counted from 1
    Lamp lamp = Lamp::sky();
    PhotonWays ways = {};           ///< the lamp's photon settings
    std::uint32_t light_group = 0;  ///< of a light source
    Rgb power = Rgb(0);             ///< of a luminaire's photon: colour of light times area
    std::optional<SourceRay> of_source = {};  ///< of a light source's photon

    /// Colour of light times area, after a path of that length.
    Rgb power_after(double way) const { return of_source ? of_source->power_after(way) : power; }
};

class PhotonShooter {
public:
    explicit PhotonShooter(const Shot&);

    /// A lamp, or all luminaires, that shoot at a target.
    struct Aim {
        enum Kind : std::uint8_t {
            source,      ///< one of POV-Ray's light sources
            luminaires,  ///< all luminaires outside of the ball around the target
            inner        ///< a luminaire that is at least partly in the ball
        };
        Kind kind = source;
        std::uint32_t lamp = 0;    ///< of a source or an inner luminaire
        std::uint32_t target = 0;  ///< in World::photon_targets
        double weight = 0;         ///< approximate colour of light times area
        double until = 0;          ///< sum of the weights up to and including this one
    };
    const std::vector<Aim>& aims() const { return aims_; }
    double weight() const { return aims_.empty() ? 0 : aims_.back().until; }

    /// Number of photons that the scene asks for at a time.
    std::uint32_t count() const;

    /// Samples a photon of an aim. The mean power of many is an unbiased estimate of the power that
    /// the lamps send to the target. Nothing if the sampled ray carries no power.
    std::optional<PhotonShot> shoot(const Aim&, const Key&) const;

private:
    void add(Aim);
    void aim_sources(std::uint32_t target);
    void aim_luminaires(std::uint32_t target);
    std::optional<PhotonShot> from_source(std::uint32_t number, const PhotonTarget&, PhotonShot,
                                          const Key&) const;
    std::optional<PhotonShot> from_luminaires(const PhotonTarget&, PhotonShot, const Key&) const;
    std::optional<PhotonShot> from_inside(LightIndex, const PhotonTarget&, PhotonShot,
                                          const Key&) const;
    Rgb seen(const Luminaire&, const Ray&, double distance, const Key&) const;
    Rgb seen(const MediaBox&, const Ray&, double distance, const Key&) const;

    struct Sender;
    template <class Glowing>
    std::optional<Sender> sender(const Glowing&, LightIndex, const Receiver& entry,
                                 const Key&) const;
    std::optional<Sender> sender(const SearchedLuminaire&, LightIndex, const Receiver& entry,
                                 const Key&) const;
    std::optional<EmittedRay> emitted(const Luminaire&, const Key&) const;
    std::optional<EmittedRay> emitted(const MediaBox&, const Key&) const;
    std::optional<double> seen_from(const Luminaire&, const Ray&, const PhotonTarget&) const;
    std::optional<double> seen_from(const MediaBox&, const Ray&, const PhotonTarget&) const;

    const Shot& shot_;
    const World& world_;
    std::vector<Aim> aims_;
};

}  // namespace candelabra
