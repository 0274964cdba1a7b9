// SPDX-License-Identifier: GPL-3.0-or-later
// Direct light at a vertex: POV-Ray's light sources one by one, or some of them when they are many,
// and luminaires, as the light strategy chooses. Strategies answer the question of
// lighting/light_query.h; none is known here by its name.
#pragma once

#include "base/random.h"
#include "scattering/scatterer.h"
#include "transport/light_ledger.h"
#include "transport/photon_light.h"
#include "transport/vertex.h"

#include <optional>
#include <vector>

namespace candelabra {

/// How many shadow rays hits get.
struct ShadowRays {
    // NOLINTNEXTLINE(google-explicit-constructor): one number for all is the plain case
    ShadowRays(int usual_number = 1, double noise = 0) : usual(usual_number), usual_noise(noise) {}

    int usual;
    /// Standard deviation of one shadow ray, times the throughput of the hit, at which a hit gets
    /// the usual number: others get more or fewer in proportion, which makes the least noise of a
    /// given number of rays. 0: all get the usual number.
    double usual_noise;
};

/// The noise that one shadow ray is expected to make (see ShadowRays), over many hits.
struct HitNoise {
    double sum = 0, squares = 0;
    int hits = 0;

    HitNoise& operator+=(const HitNoise& other) {
        sum += other.sum;
        squares += other.squares;
        hits += other.hits;
        return *this;
    }
};

/// What light that arrives at a vertex is asked for: the answer to it of one layer, or of media.
struct LitLayer {
    const Vertex& vertex;
    Scatterer scatterer;
    Vec3 throughput = Vec3(1);  ///< of the radiance that the layer sends, in the sample
    bool highlights = true;     ///< phong and specular ones count
    bool sources = true;        ///< light sources and their photons count
    bool luminaires = true;     ///< they and their photons count
    bool sky = true;            ///< so far as it is a luminaire
    /// Light of luminaires is part of what this gathers; null: nothing is.
    const Radiosity* radiosity = nullptr;

    double grain(const Key&) const;  ///< the random number of the finish's `crand`
    /// Whether it shows light that photons bring, instead of what comes straight through targets.
    /// Where the scene asks for no photons in media these are dark behind a target, as in POV-Ray.
    bool collects() const {
        return scatterer.in_air() ? scatterer.phase().collects()
                                  : vertex.material->photons.collects;
    }
};

/// Radiance towards the viewer by light that comes straight from lights and luminaires; an unbiased
/// estimate. One for each job: it keeps scratch memory.
class DirectLight {
public:
    /// `photons`: null where there are none.
    DirectLight(const World& world, const ShadowRays& rays,
                std::shared_ptr<Photons> photons = nullptr)
        : world_(world), shadow_rays_(rays), photons_(std::move(photons)) {}

    Vec3 operator()(const LitLayer&, const Key&, LightLedger&);

    /// In proportion to what is expected to arrive of luminaires at a point between surfaces; below
    /// 0 where that is not known. Precondition: there are some.
    double expected_luminaires(const Vec3& position) const;
    /// Of the sample that is followed from now on.
    void begin(std::uint32_t sample) { photons_.begin(sample); }
    const PhotonLight& photons() const { return photons_; }
    PhotonLight& photons() { return photons_; }

    /// Of all hits so far at which it was known.
    const HitNoise& noise() const { return noise_; }

private:
    /// A point of a luminaire on a line, and the density of its direction by that luminaire.
    struct Met {
        LightHit meeting;
        LightIndex light;
    };
    struct Distance {
        double distance, tolerance;  ///< of a hit
    };

    Vec3 from_sky(const LitLayer&, const Key&, LightLedger&) const;
    Vec3 from_sources(const LitLayer&, const Key&, LightLedger&);
    Vec3 from_drawn_sources(const SourceSet&, const LitLayer&, const Key&, LightLedger&);
    Vec3 from_source(std::uint32_t light, double weight, const LitLayer&, const Key&, LightLedger&);
    /// `before`: the radiance that arrives of point lights.
    Vec3 from_luminaires(const LitLayer&, const Key&, const Vec3& before, LightLedger&);
    template <LightAnswer Answer>
    Vec3 from_answer(const Answer&, const LitLayer&, const Key&, LightLedger&);
    /// Density: of a drawn point, by its direction and the luminaire's own density.
    template <class Density>
    Vec3 from_luminaire(const LightPick&, const LitLayer&, const Key&, LightLedger&,
                        const Density&);
    template <class Density>
    Vec3 from_direction(const Vec3&, const LightTree* meetings, const LitLayer&, const Key&,
                        LightLedger&, const Density&);

    std::optional<ProbeHit> sight_past_clear(const Ray&, double tolerance) const;
    template <class Visit>
    void for_densities(LightIndex, const LitLayer&, const Vec3& direction, const Distance&,
                       const Visit&);
    /// Weight: by the luminaire and the density with which it says the point is drawn.
    template <class Weight>
    Vec3 seen_towards(const LitLayer&, const Vec3& direction, LightLedger&, const Weight&);
    Vec3 light_left(const LitLayer&, const Ray&, double distance) const;
    void meet_along(const LightTree&, const Vertex&, const Receiver&, const Vec3& direction);
    template <class Weight>
    Vec3 seen_along(const LitLayer&, const Vec3& direction, LightLedger&, const Weight&) const;

    void record(LightLedger&, LightIndex, const Vec3& seen, const Vec3& throughput,
                std::uint64_t rays) const;
    static Vec3 gathered(const LitLayer&, const Vec3& light);
    template <LightAnswer Answer>
    double chance_of_asking(const Answer&, const LitLayer&, const Vec3& straight,
                            const Vec3& before) const;
    template <LightAnswer Answer>
    int rays_at(const Answer&, const LitLayer&, const Vec3& straight);

    const World& world_;
    ShadowRays shadow_rays_;
    PhotonLight photons_;
    Key medium_key_;         ///< of what media leave of the light that is asked for
    double asked_here_ = 1;  ///< shadow rays that the hit is expected to get
    HitNoise noise_;
    // Kept from hit to hit for their memory.
    LightSamples samples_;
    LightHits meetings_;
    std::vector<Met> met_;  ///< along the line that is asked, nearest first
};

}  // namespace candelabra
