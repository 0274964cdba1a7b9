// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/cluster_descent.h"

#include "base/random.h"
#include "lighting/draw.h"
#include "lighting/tuning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

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
/// strengths tell, or reflects more of it. `centre` and `half`: of a box around the cluster.
/// proxy(): of the cluster.
template <class Proxy>
bool near(const Vec3& centre, const Vec3& half, const Vec3& position, GlossyLobes lobes,
          const Proxy& proxy) {
    const Vec3 v = centre - position;
    const double radii2 = dot(v, v) / dot(half, half);
    constexpr double any = tuning::near_radii, turned = tuning::near_radii_turned;
    if (lobes && radii2 < tuning::near_radii2_of_lobe * lobes->sharpness) return true;
    if (!(radii2 < turned * turned)) return false;
    return radii2 < any * any || turned_apart(proxy());
}

double estimate(const LightTree& tree, const LightCluster& c, const LightProxy& g,
                const Receiver& point, GlossyLobes lobes) {
    const Falloff* falloff = tree.falloff(c);
    double square = irradiance(g, point);
    if (lobes) square *= lobes->reflected(g.centre - point.position, point.normal, g.radius);
    return falloff ? square * against_square_law(*falloff, g.centre - point.position, g.radius)
                   : square;
}

/// Divides near clusters at a point by the estimated light of their halves, from the first one
/// downwards.
class Halving {
public:
    Halving(const LightTree& tree, const Receiver& point, GlossyLobes lobes)
        : tree_(tree), point_(point), lobes_(lobes) {}

    /// Returns the probability of the first half. Nothing if the cluster is sampled as a whole, by
    /// the strength of its luminaires. `known`: the cluster's proxy; null: not known yet.
    std::optional<double> divide(const LightCluster& c, const LightProxy* known) {
        if (c.count == 1 || !is_near(c, known)) return {};
        const auto [first, second] = tree_.halves(c);
        halves = {first, second};
        const double of_first = tree_.intensity(first), of_second = tree_.intensity(second);
        proxies = {tree_.light_proxy(first, of_first), tree_.light_proxy(second, of_second)};
        if (of_first == 0 || of_second == 0) return of_first > 0 ? 1 : 0;
        const double a = estimate(tree_, first, proxies[0], point_, lobes_),
                     b = estimate(tree_, second, proxies[1], point_, lobes_);
        if (!(a + b > 0)) return {};
        return a / (a + b);
    }

    std::array<LightCluster, 2> halves;  ///< of the cluster that was divided last
    std::array<LightProxy, 2> proxies;

private:
    bool is_near(const LightCluster& c, const LightProxy* known) const {
        if (known)
            return near(known->centre, known->half, point_.position, lobes_,
                        [&]() -> const LightProxy& { return *known; });
        const Box box = tree_.box(c);
        return near(box.centre(), 0.5 * box.size(), point_.position, lobes_,
                    [&] { return tree_.light_proxy(c); });
    }

    const LightTree& tree_;
    const Receiver& point_;
    GlossyLobes lobes_;
};

}  // namespace

MemberDraw::MemberDraw(const LightTree& tree, const LightCluster& cluster, const Receiver& point,
                       const Key& key, double u, GlossyLobes lobes)
    : tree_(&tree), point_(&point), lobes_(lobes), key_(key), cluster_(cluster), u_(u) {}

bool MemberDraw::descend() {
    Halving halving(*tree_, *point_, lobes_);
    const auto share_of_first = halving.divide(cluster_, proxy_ ? &*proxy_ : nullptr);
    if (!share_of_first) return false;
    const double share = *share_of_first;
    const bool first = u_ < share;
    u_ = first ? u_ / share : (u_ - share) / (1 - share);
    u_ = std::fmin(u_, below_1);
    const double step = first ? share : 1 - share;
    probability_ *= step;
    since_fresh_ *= step;
    cluster_ = halving.halves[first ? 0 : 1];
    proxy_ = halving.proxies[first ? 0 : 1];
    if (since_fresh_ < worn_out) {
        u_ = candelabra::draw(key_, Purpose::light_choice, level_);
        since_fresh_ = 1;
    }
    ++level_;
    tree_->fetch_halves(cluster_);
    return true;
}

DrawnMember MemberDraw::draw() const {
    const std::uint32_t place = tree_->draw(cluster_, u_);
    return {place, probability_ * tree_->share(cluster_, place)};
}

void descend_together(std::span<MemberDraw* const> draws) {
    std::array<MemberDraw*, draws_together> going;
    std::ranges::copy(draws, going.begin());
    std::size_t count = draws.size();
    while (count > 0)
        for (std::size_t i = 0; i < count;) {
            if (going[i]->descend())
                ++i;
            else
                going[i] = going[--count];
        }
}

DrawnMember member_of(const LightTree& tree, LightCluster c, const Receiver& point, const Key& key,
                      double u, GlossyLobes lobes) {
    MemberDraw draw(tree, c, point, key, u, lobes);
    while (draw.descend()) {
    }
    return draw.draw();
}

double probability_of(const LightTree& tree, LightCluster c, const Receiver& point,
                      std::uint32_t place, GlossyLobes lobes) {
    double probability = 1;
    Halving halving(tree, point, lobes);
    std::optional<LightProxy> proxy;
    while (const auto share = halving.divide(c, proxy ? &*proxy : nullptr)) {
        const bool first = halving.halves[0].holds(place);
        probability *= first ? *share : 1 - *share;
        c = halving.halves[first ? 0 : 1];
        proxy = halving.proxies[first ? 0 : 1];
    }
    return tree.dark(c) ? 0 : probability * tree.share(c, place);
}

}  // namespace candelabra
