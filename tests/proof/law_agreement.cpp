// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/items.h"
#include "proof/laws.h"
#include "render/render.h"

#include <variant>

namespace candelabra::proof {

namespace {

/// What rounds add is little beside the noise of a picture of few samples, so each is the mean of
/// some.
constexpr int pictures_by_noise = 2, pictures_by_itself = 8;

/// How a picture gets its number of samples.
struct Refinement {
    double noise = 0;   ///< of --noise; 0: no number is asked for
    bool even = false;  ///< no more samples than those that all pixels get first
};

/// A picture whose pixels have a few samples, and more where their neighbours are noisy. Both
/// pictures of a pair have the same seed, so that they differ only where there are more. Rules that
/// compare single rays are POV-Ray's and have a bias; so all pixels have as many samples then.
Image by_noise(const Prepared& scene, const Refinement& wanted, int samples, int seed,
               const Deadline& end) {
    RenderSettings settings = scene.settings(wanted.noise > 0 ? 8 * samples : 0, (seed + 1) / 2);
    settings.noise = wanted.noise;
    settings.antialias_depth = 2;  // at most 16 samples, of which the first round has few
    auto plan = plan_of(scene.shot(), settings, [&end] { return end.over(); });
    if (!plan) return {};
    if (wanted.even || !std::holds_alternative<NoiseRule>(plan->rule)) {
        plan->settings.noise = 0;
        plan->settings.samples = static_cast<int>(plan->samples);
        plan->rule = NoiseRule();
    }
    const int pictures = wanted.noise > 0 ? pictures_by_noise : pictures_by_itself;
    Image mean(settings.width, settings.height);
    for (int i = 0; i < pictures; ++i) {
        plan->settings.seed = settings.seed * pictures + i;
        const Image image = rendered(*plan, end);
        if (image.pixels.empty()) return {};
        for (std::size_t p = 0; p < mean.pixels.size(); ++p)
            mean.pixels[p] += image.pixels[p] / pictures;
    }
    return mean;
}

std::vector<Term> seen_by_noise(const Script& script, const Refinement& wanted) {
    std::vector<Term> terms = picture(script);
    terms.front().view = [wanted](const Prepared& scene, int samples, int seed,
                                  const Deadline& end) {
        return by_noise(scene, wanted, samples, seed, end);
    };
    return terms;
}

}  // namespace

Claims any_strategy(const Script& script, Dice& dice) {
    std::vector<std::string> others = {"light_bvh mis", "light_octree alone", "light_octree paper",
                                       "light_octree max_depth 20"};
    for (const ItemInfo* info : items_of("Light samplers"))
        if (info->name != "light_octree") others.push_back(std::string(info->name));
    const std::string other = dice.pick(others);
    return {same_mean("light_octree = " + other,
                      picture(with_setting(script, "light_sampler", "light_octree")),
                      picture(with_setting(script, "light_sampler", other)))};
}

Claims any_index(const Script& script, Dice&) {
    Claims claims;
    const auto indices = items_of("Indexes");
    const std::string first(indices.front()->name);
    for (const ItemInfo* info : indices.subspan(1)) {
        const std::string other(info->name);
        claims.push_back(same_bytes(first + " = " + other,
                                    picture(with_setting(script, "index", first)),
                                    picture(with_setting(script, "index", other))));
    }
    return claims;
}

Claims more_where_noisy(const Script& script, Dice& dice) {
    const double noise = dice.chance(0.5) ? dice.between(0.01, 0.1) : 0;
    return {same_mean(noise > 0 ? "by --noise = even" : "without a number of samples = even",
                      seen_by_noise(script, {noise}), seen_by_noise(script, {noise, true}))};
}

}  // namespace candelabra::proof
