// SPDX-License-Identifier: GPL-3.0-or-later
// Direct light at a vertex, from POV-Ray's light sources one by one, or some of them if they are
// many, and from luminaires as the light strategy chooses. Strategies implement the interface of
// lighting/light_query.h; this code knows none of them by name.
#pragma once

#include "base/random.h"
#include "scattering/scatterer.h"
#include "transport/light_kinds.h"
#include "transport/light_ledger.h"
#include "transport/photon_light.h"
#include "transport/vertex.h"

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

/// Expected noise of one shadow ray (see ShadowRays), over many hits.
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

/// The layer or the media at a vertex that respond to light, and the kinds of light that count.
struct LitLayer {
    const Vertex& vertex;
    Scatterer scatterer;
    LightKinds light;           ///< the kinds that count
    Vec3 throughput = Vec3(1);  ///< of the layer's radiance, in the sample
    bool highlights = true;     ///< phong and specular highlights count
    /// Settings of the radiosity that gathers the luminaires' light; null: nothing gathers it.
    const Radiosity* radiosity = nullptr;

    double grain(const Key&) const;  ///< the random number of the finish's `crand`
    /// Whether photons light the layer instead of direct light through targets. If the scene asks
    /// for no photons in media, media are dark behind a target, as in POV-Ray.
    bool collects() const {
        return scatterer.in_air() ? scatterer.phase().collects()
                                  : vertex.material->photons.collects;
    }
};

/// Radiance towards the viewer by direct light of light sources and luminaires; an unbiased
/// estimate. Each job has its own: it keeps scratch memory.
class DirectLight {
public:
    /// `photons`: null where there are none.
    DirectLight(const World& world, const ShadowRays& rays,
                std::shared_ptr<Photons> photons = nullptr)
        : world_(world), shadow_rays_(rays), photons_(std::move(photons)) {}

    Vec3 operator()(const LitLayer&, const Key&, LightLedger&);

    /// Expected light of luminaires at a point between surfaces, up to a constant factor; below 0
    /// where it is not known. Precondition: there are luminaires.
    double expected_luminaires(const Vec3& position) const;
    /// Selects the sample that is followed from now on.
    void begin(std::uint32_t sample) { photons_.begin(sample); }
    const PhotonLight& photons() const { return photons_; }
    PhotonLight& photons() { return photons_; }

    /// Over all hits so far at which the expected noise was known.
    const HitNoise& noise() const { return noise_; }

private:
    /// A point of a luminaire on a line, with the luminaire's pdf of that direction.
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
    /// `before`: the radiance by light sources and photons.
    Vec3 from_luminaires(const LitLayer&, const Key&, const Vec3& before, LightLedger&);
    template <LightAnswer Answer>
    Vec3 from_answer(const Answer&, const LitLayer&, const Key&, LightLedger&);
    /// Density: returns the pdf of a sampled point, given its direction and the luminaire's own
    /// pdf.
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
    /// Weight: returns the factor on a luminaire's radiance, given the luminaire and its pdf of the
    /// point.
    template <class Weight>
    Vec3 seen_towards(const LitLayer&, const Vec3& direction, LightLedger&, const Weight&);
    Vec3 light_left(const LitLayer&, const Ray&, double distance, bool ends = true) const;
    static void add_further(const Luminaire&, const Ray&, LightHits&);
    void meet_along(const LightTree&, const Vertex&, const Receiver&, const Vec3& direction);
    template <class Weight>
    Vec3 seen_along(const LitLayer&, const Vec3& direction, LightLedger&, const Weight&) const;

    void record(LightLedger&, LightIndex, const Vec3& seen, const Vec3& throughput,
                std::uint64_t rays) const;
    Vec3 left_by_lamp(const LitLayer&, const Luminaire&, const Ray&, double distance) const;
    Vec3 emitted(const LitLayer&, const Luminaire&, const Ray&, double distance) const;
    static Vec3 gathered(const LitLayer&, const Vec3& light);
    template <LightAnswer Answer>
    double chance_of_asking(const Answer&, const LitLayer&, const Vec3& straight,
                            const Vec3& before) const;
    template <LightAnswer Answer>
    int rays_at(const Answer&, const LitLayer&, const Vec3& straight);

    const World& world_;
    ShadowRays shadow_rays_;
    PhotonLight photons_;
    Key medium_key_;         ///< random numbers of media on the current shadow ray
    double asked_here_ = 1;  ///< expected number of shadow rays at the current hit
    HitNoise noise_;
    // Kept as members to reuse their memory.
    LightSamples samples_;
    LightHits meetings_;
    std::vector<Met> met_;  ///< along the current line, nearest first
};

}  // namespace candelabra
