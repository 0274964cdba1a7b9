// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/light_bvh.h"

#include "base/random.h"
#include "lighting/draw.h"
#include "lighting/tuning.h"
#include "luminaire/light_proxy.h"

#include <algorithm>

namespace candelabra {

namespace {

/// Probability below which the random number that is reused level by level is replaced by a new
/// one.
constexpr double worn_out_walk = 1e-7;

/// cos(max(0, a - b)) for angles from 0 to pi given by cosine and, for b, also by sine.
double cosine_beyond(double cos_a, double cos_b, double sin_b) {
    if (cos_a >= cos_b) return 1;
    return cos_a * cos_b + std::sqrt(std::fmax(0, (1 - cos_a) * (1 + cos_a))) * sin_b;
}

/// Upper bound, in the manner of the paper, of the light of a node's luminaires at a point: as if
/// all were at the distance of the node's centre, each turned to the point and raised above its
/// horizon as well as anywhere in the node's sphere.
double importance(const LightNode& node, const Receiver& point) {
    const Vec3 v = node.centre - point.position;
    const double d2 = dot(v, v), r2 = node.radius * node.radius;
    if (d2 <= r2) return node.intensity / std::fmax(r2, std::numeric_limits<double>::min());
    const double distance = std::sqrt(d2), sine = node.radius / distance,
                 cosine = std::sqrt((1 - sine) * (1 + sine));
    const double height = point.cosine(v / distance);
    if (height <= -(sine + ProxyMargins<double>::horizon_slack)) return 0;
    const double lifted =
        std::fmax(cosine_beyond(std::fmin(height, 1), cosine, sine), tuning::min_height);
    const Vec3 axis(node.axis);
    double turned = 1;
    if (axis != Vec3(0)) {
        // The angle of spread and that of the sphere, together; beyond a right angle some normal
        // may face the point.
        const double cos_both = node.cos_spread * cosine - node.sin_spread * sine;
        const double sin_both = node.sin_spread * cosine + node.cos_spread * sine;
        const double seen = std::fmin(std::abs(dot(axis, v)) / distance, 1);
        if (cos_both > 0)
            turned = std::fmax(cosine_beyond(seen, cos_both, sin_both), tuning::min_facing);
    }
    return node.intensity * lifted * turned / d2;
}

}  // namespace

BuiltLightBvh::BuiltLightBvh(const ChoosableLights& lights, const LightBvh& settings, int threads)
    : nodes_(build_light_hierarchy(lights, threads)), leaf_of_(lights.size()) {
    if (settings.mis) tree_ = LightTree(lights, threads);
    for (std::uint32_t i = 0; i < nodes_.size(); ++i)
        if (nodes_[i].leaf) leaf_of_[nodes_[i].second] = i;
}

void BuiltLightBvh::choose(const Receiver& point, const Key& key, LightPicks& picks) const {
    if (nodes_.empty()) return;
    double u = uniform(key, Purpose::light_choice), probability = 1, since_fresh = 1;
    std::uint32_t here = 0;
    for (std::uint64_t level = 1; !nodes_[here].leaf; ++level) {
        const std::uint32_t first = here + 1, second = nodes_[here].second;
        const double weight1 = importance(nodes_[first], point),
                     weight2 = importance(nodes_[second], point);
        const double sum = weight1 + weight2;
        if (!(sum > 0)) return;
        const double share = weight1 / sum;
        const bool left = weight2 == 0 || u < share;
        u = left ? u / share : (u - share) / (1 - share);
        u = std::fmin(u, below_1);
        const double step = left ? share : weight2 / sum;
        probability *= step;
        since_fresh *= step;
        here = left ? first : second;
        if (since_fresh < worn_out_walk) {
            u = draw(key, Purpose::light_choice, level);
            since_fresh = 1;
        }
    }
    picks.push_back(
        {nodes_[here].second, std::fmax(probability, std::numeric_limits<double>::min())});
}

double BuiltLightBvh::expected(const Receiver& point, const Key&, LightIndex light) const {
    double probability = 1;
    for (std::uint32_t here = leaf_of_[light]; here != 0; here = nodes_[here].parent) {
        const LightNode& parent = nodes_[nodes_[here].parent];
        const std::uint32_t first = nodes_[here].parent + 1;
        const std::uint32_t other = here == first ? parent.second : first;
        const double weight = importance(nodes_[here], point);
        if (weight == 0) return 0;
        probability *= weight / (weight + importance(nodes_[other], point));
    }
    return std::fmax(probability, std::numeric_limits<double>::min());
}

void BuiltLightBvh::At::sample(const Key& key, LightSamples& samples) const {
    if (bsdf_) {
        samples.direction = bsdf_->sample(place_on_light(key.with_branch(1)));
        samples.tree = &bvh_.tree();
    }
    bvh_.choose(receiver_, key, samples.picks);
}

std::size_t BuiltLightBvh::memory_bytes() const {
    return nodes_.capacity() * sizeof(LightNode) + leaf_of_.capacity() * sizeof(std::uint32_t) +
           tree_.memory_bytes();
}

BuiltLightBvh build(const LightBvh& settings, const LightScene& scene, int threads) {
    return scene.lights ? BuiltLightBvh(*scene.lights, settings, threads) : BuiltLightBvh();
}

}  // namespace candelabra
