// SPDX-License-Identifier: GPL-3.0-or-later
// The question that every light strategy answers: what to ask for light at one receiver. Each
// strategy has a type of answers, which is made once for a receiver and drawn from for each of its
// shadow rays. Those who estimate light know strategies by this alone.
#pragma once

#include "base/random.h"
#include "lighting/bsdf_lobes.h"
#include "lighting/light_guide.h"
#include "lighting/light_tree.h"
#include "lighting/pick.h"

#include <concepts>

namespace candelabra {

struct LightQuery {
    const Receiver& receiver;
    const BsdfLobes& lobes;   ///< how the receiver answers light
    const BsdfSampler* bsdf;  ///< null: luminaires are wanted, and no directions
    const LightProbe* scene;  ///< null: the scene is not there to be asked
};

/// What to ask for one shadow ray: the estimate is the sum over all of it.
struct LightSamples {
    LightPicks picks;               ///< luminaires, of each of which a point is to be drawn
    std::optional<Vec3> direction;  ///< unit; all luminaires that are seen in it count

    void clear() {
        picks.clear();
        direction.reset();
    }
};

/// A strategy's answer at a receiver.
template <class T>
concept LightAnswer = requires(const T& at, const Key& key, LightSamples& samples,
                               const Vec3& direction) {
    at.sample(key, samples);  // adds to what is there
    {
        at.expected(key, LightIndex{})
        } -> std::same_as<double>;  // number of times the luminaire is picked, for sample()'s key
    // Density of a point of a luminaire by all ways together, per steradian: its direction, how
    // often the luminaire is expected to be picked, and the density that it then has.
    { at.pdf(direction, double{}, double{}) } -> std::same_as<double>;
    // Share of the picks in it, for luminaires that no direction meets: volumes.
    { at.picked() } -> std::same_as<double>;
    // Standard deviation that one shadow ray's irradiance is expected to have; below 0: not known.
    { at.noise() } -> std::same_as<double>;
    { at.irradiance() } -> std::same_as<double>;  // that is expected; known where the noise is
    // In proportion to what is expected to arrive of all luminaires; below 0: not known.
    { at.expected_light() } -> std::same_as<double>;
    // Finds the luminaires in a direction; null: the scene does.
    { at.meetings() } -> std::convertible_to<const LightTree*>;
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
    double picked() const { return 1; }
    double noise() const { return -1; }
    double irradiance() const { return 0; }
    double expected_light() const { return -1; }
    const LightTree* meetings() const { return nullptr; }

private:
    const Built& built_;
    const Receiver& receiver_;
};

}  // namespace candelabra
