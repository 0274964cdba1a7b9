// SPDX-License-Identifier: GPL-3.0-or-later
// The interface of light strategies: which luminaires or directions to sample for one receiver.
// Each strategy has a type of answer, which is made once for a receiver and sampled for each of its
// shadow rays. Estimators of light know strategies only by this interface.
#pragma once

#include "base/random.h"
#include "lighting/bsdf_lobes.h"
#include "lighting/light_tree.h"
#include "lighting/pick.h"
#include "lighting/probe.h"

#include <concepts>
#include <optional>
#include <span>

namespace candelabra {

struct LightQuery {
    const Receiver& receiver;
    const BsdfLobes& lobes;   ///< the receiver's scattering
    const BsdfSampler* bsdf;  ///< null: only luminaires are wanted, no directions
    const LightProbe* scene;  ///< null: the scene is not available
    bool sky = false;         ///< whether the sky counts as well
};

/// Samples for one shadow ray: the estimate is the sum over all of them.
struct LightSamples {
    LightPicks picks;                 ///< luminaires, on each of which a point is to be sampled
    std::optional<Vec3> direction;    ///< unit; all luminaires that are visible in it count
    const LightTree* tree = nullptr;  ///< finds the luminaires in the direction; null: rays do

    void clear() {
        picks.clear();
        direction.reset();
        tree = nullptr;
    }
};

/// The light that a strategy expects at a receiver, if it knows it.
struct LightEstimate {
    struct ShadowRay {
        double irradiance;  ///< mean
        double noise;       ///< standard deviation of the irradiance by one shadow ray
    };
    double light;  ///< irradiance, as luminance, as far as it is known which light arrives
    std::optional<ShadowRay> ray = {};
    /// Radiance of colour 1 that a surface with highlights sends to its viewer for light of colour
    /// 1: the mean over the light that is expected, by its directions. None: not known.
    std::optional<double> response = {};
};

/// A strategy's answer at a receiver.
template <class T>
concept LightAnswer = requires(const T& at, const Key& key, LightSamples& samples,
                               const Vec3& direction) {
    at.sample(key, samples);  // appends
    // Expected number of times that sample() picks the luminaire with the key.
    { at.expected(key, LightIndex{}) } -> std::same_as<double>;
    // Pdf per steradian of a point of a luminaire by all ways together. Arguments: its direction,
    // the expected number of times that the luminaire is picked, and the pdf of the point if it is
    // picked. No direction hits media: theirs is the product of the last two.
    { at.pdf(direction, double{}, double{}) } -> std::same_as<double>;
    { at.estimate() } -> std::same_as<std::optional<LightEstimate>>;
    // Whether the sky, if it counts, is among what sample() picks, as sky_light, and whether it
    // shines in the directions that sample() returns. If not, it must be sampled apart. The pdf of
    // a direction to it is that of a point of a luminaire.
    { at.takes_sky() } -> std::same_as<bool>;
};

/// An answer that makes several samples at once in less time.
template <class T>
concept SamplesTogether = requires(const T& at, std::span<const Key> keys,
                                   std::span<LightSamples> samples) {
    at.sample(keys, samples);
};

/// The answer of strategies that only pick luminaires.
template <class Built>
class PickAnswer {
public:
    PickAnswer(const Built& built, const Receiver& receiver) : built_(built), receiver_(receiver) {}

    void sample(const Key& key, LightSamples& samples) const {
        built_.choose(receiver_, key, samples.picks);
    }
    double expected(const Key& key, LightIndex light) const {
        return built_.expected(receiver_, key, light);
    }
    double pdf(const Vec3&, double expected, double of_point) const { return expected * of_point; }
    std::optional<LightEstimate> estimate() const { return {}; }
    bool takes_sky() const { return false; }

private:
    const Built& built_;
    const Receiver& receiver_;
};

}  // namespace candelabra
