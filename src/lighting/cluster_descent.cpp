// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/cluster_descent.h"

#include "base/random.h"
#include "lighting/draw.h"
#include "lighting/tuning.h"

#include <cmath>

namespace candelabra {

namespace {

/// Probability below which the random number that is reused level by level is replaced by a new
/// one.
constexpr double worn_out = 1e-7;

/// Whether the luminaires of a cluster shine more to some sides, and not all to the same ones.
bool turned_apart(const LightProxy& g) {
    constexpr double alike = 0.8;  // length of the mean axis of luminaires that are about parallel
    return g.evenness < 1 && dot(g.axis, g.axis) < alike * alike;
}

/// Whether a point is so near that it gets more light from some members of a cluster than their
/// strengths tell, or reflects more of it.
bool near(const LightTree& tree, const LightCluster& c, const Vec3& position, GlossyLobes lobes) {
    const Box box = tree.box(c);
    const Vec3 v = box.centre() - position, half = 0.5 * box.size();
    const double radii2 = dot(v, v) / dot(half, half);
    constexpr double any = tuning::near_radii, turned = tuning::near_radii_turned;
    if (lobes && radii2 < tuning::near_radii2_of_lobe * lobes->sharpness) return true;
    if (!(radii2 < turned * turned)) return false;
    return radii2 < any * any || turned_apart(tree.light_proxy(c));
}

double estimate(const LightTree& tree, const LightCluster& c, const Receiver& point,
                GlossyLobes lobes) {
    const LightProxy g = tree.light_proxy(c);
    const Falloff* falloff = tree.falloff(c);
    double square = irradiance(g, point);
    if (lobes) square *= lobes->reflected(g.centre - point.position, point.normal, g.radius);
    return falloff ? square * against_square_law(*falloff, g.centre - point.position, g.radius)
                   : square;
}

struct Halves {
    LightCluster first, second;
    double share;  ///< probability of the first
};

/// Divides a near cluster at a point by the estimated light of its halves. Nothing if the cluster
/// is sampled as a whole, by the strength of its luminaires.
std::optional<Halves> divided(const LightTree& tree, const LightCluster& c, const Receiver& point,
                              GlossyLobes lobes) {
    if (c.count == 1 || !near(tree, c, point.position, lobes)) return {};
    const auto [first, second] = tree.halves(c);
    if (tree.dark(first)) return Halves{first, second, 0};
    if (tree.dark(second)) return Halves{first, second, 1};
    const double a = estimate(tree, first, point, lobes), b = estimate(tree, second, point, lobes);
    if (!(a + b > 0)) return {};
    return Halves{first, second, a / (a + b)};
}

}  // namespace

DrawnMember member_of(const LightTree& tree, LightCluster c, const Receiver& point, const Key& key,
                      double u, GlossyLobes lobes) {
    double probability = 1, since_fresh = 1;
    for (std::uint64_t level = 1;; ++level) {
        const auto halves = divided(tree, c, point, lobes);
        if (!halves) break;
        const double share = halves->share;
        const bool first = u < share;
        u = first ? u / share : (u - share) / (1 - share);
        u = std::fmin(u, below_1);
        const double step = first ? share : 1 - share;
        probability *= step;
        since_fresh *= step;
        c = first ? halves->first : halves->second;
        if (since_fresh < worn_out) {
            u = draw(key, Purpose::light_choice, level);
            since_fresh = 1;
        }
    }
    const std::uint32_t place = tree.draw(c, u);
    return {place, probability * tree.share(c, place)};
}

double probability_of(const LightTree& tree, LightCluster c, const Receiver& point,
                      std::uint32_t place, GlossyLobes lobes) {
    double probability = 1;
    while (const auto halves = divided(tree, c, point, lobes)) {
        const bool first = halves->first.holds(place);
        probability *= first ? halves->share : 1 - halves->share;
        c = first ? halves->first : halves->second;
    }
    return tree.dark(c) ? 0 : probability * tree.share(c, place);
}

}  // namespace candelabra
