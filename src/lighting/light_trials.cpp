// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/light_trials.h"

#include "base/random.h"

#include <algorithm>

namespace {

/// Shadow rays for each entry.
constexpr std::uint32_t rays = 6;
/// Places that these rays start from.
constexpr std::size_t most_places = 8;
/// Greatest share of an entry as a multiple of the mean of those of which something arrives, and
/// the least for what is far.
constexpr double least = 0.02, greatest = 4;
/// What all entries of which nothing arrives may count together, as a share of what the others do:
/// a sun behind shutters must not take all rays.
constexpr double most_unseen = 0.1;

double number(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return uniform(Key{a, b, c, 1}, Purpose::light_representative);
}

}  // namespace

double arriving(std::span<const Luminaire> luminaires, LightIndex light, const Receiver& from,
                const Vec2& u, const LightProbe& probe) {
    const auto drawn = sample(luminaires[light], from.point, u);
    if (!drawn) return 0;
    const double height = dot(drawn->direction, from.point.normal),
                 cosine = from.point.both_sides ? std::abs(height) : height;
    const bool source = std::holds_alternative<SourceEmitter>(luminaires[light].emitter);
    if (!(cosine > 0) && !source) return 0;
    const auto sight = probe({from.point.position, drawn->direction}, from.tolerance);
    if (source) {
        const bool hidden = sight && sight->distance < drawn->distance * (1 - 1e-9);
        return hidden ? 0 : unoccluded(luminaires[light], from.point);
    }
    return sight && sight->light == light ? sight->luminance * cosine / drawn->density : 0;
}

float cautious_share(float share, const Box& cell, const Glow& g) {
    const double reach = 0.5 * length(cell.size()) + g.radius;
    const Vec3 offset = g.centre - cell.centre();
    const double lowest = std::fmin(reach * reach / dot(offset, offset), 1);
    return std::fmax(share, static_cast<float>(lowest));
}

std::vector<float> arriving_shares(const LightCut& cut, const LightTree& tree,
                                   std::span<const Luminaire> luminaires,
                                   std::span<const Receiver> receivers, const LightProbe& probe) {
    const std::size_t places = std::min(receivers.size(), most_places);
    std::vector<CutWeights> weights(places);
    for (std::size_t i = 0; i < places; ++i) cut.weigh(receivers[i].point, weights[i]);
    std::vector<float> shares(cut.entries(), 0);
    double sum = 0, seen = 0, unseen = 0;
    for (std::size_t entry = 0; entry < cut.entries(); ++entry) {
        double squares = 0, weight_sum = 0;
        int tried = 0;
        const LightCluster& cluster = cut.cluster(entry);
        for (std::uint32_t i = 0; i < rays; ++i) {
            const auto n = static_cast<std::uint32_t>(entry);
            const std::size_t place = (i + entry) % places;
            const Receiver& from = receivers[place];
            const double weight = weights[place].weight[entry];
            if (!(weight > 0)) continue;
            ++tried;
            weight_sum += weight;
            const std::uint32_t member = tree.draw(cluster, number(n, i, 0));
            const double given = arriving(luminaires, tree.light(member), from,
                                          {number(n, i, 1), number(n, i, 2)}, probe) /
                                 (tree.share(cluster, member) * weight);
            squares += given * given;
        }
        if (tried == 0) continue;
        const double share = std::sqrt(squares / tried);
        shares[entry] = static_cast<float>(share);
        sum += share * weight_sum / tried;
        (share > 0 ? seen : unseen) += weight_sum / tried;
    }
    if (!(sum > 0)) return std::vector<float>(cut.entries(), 1.0f);
    const double mean = sum / seen;
    const double dark = unseen > 0 ? std::fmin(least, most_unseen * seen / unseen) : least;
    for (float& share : shares)
        share = static_cast<float>(share > 0 ? std::clamp(share / mean, least, greatest) : dark);
    return shares;
}
