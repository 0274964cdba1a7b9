// SPDX-License-Identifier: GPL-3.0-or-later
// Light at a layer of what the light strategy of the shot chooses: luminaires, and with them the
// sky and light sources as far as one draw is made among all of them. Shadow rays go to what is
// chosen, and in directions that the strategy chooses. Strategies implement the interface of
// lighting/light_query.h; this code knows none of them by name.
#pragma once

#include "base/function_ref.h"
#include "base/rgb.h"
#include "lighting/light_query.h"
#include "transport/shadow_ray.h"
#include "world/shot.h"

#include <optional>
#include <vector>

namespace candelabra {

/// Number of shadow rays at each hit.
struct ShadowRays {
    // NOLINTNEXTLINE(google-explicit-constructor): one number for all is the plain case
    ShadowRays(int usual_number = 1, double noise = 0) : usual(usual_number), usual_noise(noise) {}

    int usual;
    /// Standard deviation of one shadow ray, times the throughput of the hit, at which a hit gets
    /// the usual number. Other hits get more or fewer in proportion, which minimises the noise for
    /// a given number of rays. 0: all get the usual number.
    double usual_noise;
};

/// Each job has its own: it keeps scratch memory.
class ChosenLight {
public:
    ChosenLight(const Shot& shot, const ShadowRays& rays)
        : shot_(shot), world_(*shot.world), rays_(rays) {}

    /// The kinds that count at a layer, and that the strategy may choose.
    LightKinds kinds_at(const LitLayer&) const;

    struct Found {
        Rgb radiance = Rgb(0);    ///< towards the viewer
        bool with_sky = false;    ///< it has the light of the sky, which the strategy chose among
    };
    /// Light of these kinds; an unbiased estimate. `before`: radiance by other light, in which
    /// noise is hidden. Precondition: there are some, none that kinds_at() does not return.
    Found operator()(const ArrivingLight&, const Key&, LightKinds, const Rgb& before);

    /// Expected irradiance at a point between surfaces, as luminance, where it is known.
    /// Precondition: there are lights to choose.
    std::optional<double> expected(const Vec3& position) const;

private:
    /// A luminaire on a shadow ray.
    struct OnRay {
        LightIndex light;
        double distance;
        double density = 0;           ///< the luminaire's pdf of the direction, if it is known
        std::optional<Hit> hit = {};  ///< of the scene, if it is known
        bool unobstructed = false;    ///< whether it is known that nothing lies before it
        std::uint64_t rays = 1;       ///< that count for it
    };
    using Weight = FunctionRef<Rgb(const OnRay&)>;  ///< see Arrival
    /// One shadow ray, or what takes its place.
    struct Asked {
        const ArrivingLight& at;
        Key key;
        double number;     ///< expected number of shadow rays at the hit
        LightKinds kinds;  ///< that count; the sky if it is among what is chosen
    };

    template <LightAnswer Answer>
    Rgb by_answer(const Answer&, const LightSamples&, const Asked&);
    template <class Density>
    Rgb by_pick(const Luminaire&, const LightPick&, const Asked&, const Key& place, const Density&);
    template <class Density>
    Rgb by_pick(const MediaBox&, const LightPick&, const Asked&, const Key& place,
                const Density&) const;
    template <class Density>
    Rgb by_direction(const LightSamples&, const Asked&, const Density&);
    template <class Density>
    Rgb from_sky(const Asked&, const Density&) const;
    Rgb seen(const ShadowRay&, const ArrivingLight&, Weight) const;

    /// What a walk along a ray met besides luminaires.
    struct Walked {
        bool open;     ///< nothing stops light from behind everything
        bool nothing;  ///< nothing dims it either
    };
    Walked walk_along(const ShadowRay&, const Asked&);
    void meet_along(const LightTree&, const ArrivingLight&, const Vec3& direction);
    static void add_further(const Luminaire&, const Ray&, LightHits&);
    template <class Visit>
    void for_densities(const OnRay&, const LitLayer&, const Vec3& direction, const Visit&);

    int rays_at(double noise_of_ray, const ArrivingLight&, const Rgb& straight) const;

    const Shot& shot_;
    const World& world_;
    ShadowRays rays_;
    // Kept as members to reuse their memory.
    std::array<LightSamples, draws_together> samples_;
    LightHits hits_;
    std::vector<OnRay> on_ray_;  ///< nearest first
};

}  // namespace candelabra
