// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/refined_cut.h"

#include "base/box.h"
#include "base/order.h"
#include "lighting/light_cut.h"
#include "lighting/tuning.h"

#include <algorithm>

namespace candelabra {

namespace {

/// A cluster with its approximate contribution to the points of the cell.
struct Entry {
    LightCluster cluster;
    double weight = 0;
    double excess = 0;  ///< its contribution to the variance of the choice

    bool operator<(const Entry& other) const {
        return excess != other.excess ? excess < other.excess : cluster.first > other.cluster.first;
    }
};

/// The weight of a cluster, whose proxy that is, in a cell around a centre.
double weight_around(const Vec3& centre, double radius, const LightTree& tree,
                     const LightCluster& cluster, const LightProxy& g) {
    const Vec3 v = g.centre - centre;
    double weight = g.strength * g.radius / (dot(v, v) + radius * radius + g.radius * g.radius);
    if (g.bent_normal != Vec3(0)) weight *= turned(g, v, radius + g.radius);
    if (const Falloff* falloff = tree.falloff(cluster))
        weight *= against_square_law(*falloff, v, radius + g.radius);
    return weight;
}

class Refinement {
public:
    Refinement(const LightTree& tree, const Box& cell)
        : tree_(tree), centre_(cell.centre()), radius_(0.5 * length(cell.size())) {}

    void refine(const CutRule& rule) {
        const auto most = std::min(static_cast<std::size_t>(rule.max_entries), CutWeights::most);
        if (tree_.has_both_laws()) {
            const auto [by_square_law, others] = tree_.halves(tree_.root());
            add(by_square_law);
            add(others);
        } else {
            add(tree_.root());
        }
        // A block of entries takes the same time whether it is full or not. There is none if all
        // lights are dark.
        while (!heap_.empty() && heap_.size() < most &&
               (heap_.size() < CutWeights::block || is_noisier_than(rule.noise))) {
            const Entry coarse = heap_.front();
            if (coarse.excess <= 0) break;
            remove_greatest(heap_);
            weights_ -= coarse.weight;
            excess_ -= coarse.excess;
            const auto [first, second] = tree_.halves(coarse.cluster);
            add(first);
            add(second);
        }
        sort_stably(heap_, {}, [](const Entry& e) { return e.cluster.first; });
    }
    const std::vector<Entry>& entries() const { return heap_; }
    double noise() const {
        double clusters = 0, singles = 0, excess = 0;
        for (const Entry& e : heap_) {
            if (e.cluster.count > 1) clusters += e.weight;
            excess += e.excess;
        }
        for (const Entry& e : heap_)
            if (e.cluster.count == 1 && e.weight < tuning::outshining * clusters)
                singles += e.weight;
        return excess > 0 ? excess / (clusters + singles) : 0;
    }

private:
    void add(const LightCluster& cluster) {
        if (tree_.dark(cluster)) return;
        const LightProxy g = tree_.light_proxy(cluster);
        const double d = length(g.centre - centre_);
        Entry entry{cluster, weight_around(centre_, radius_, tree_, cluster, g), 0};
        if (cluster.count > 1) {
            // Seen from anywhere in the cell, the distance and height of the members differ by
            // about this fraction.
            const double spread = g.radius / std::fmax(d - radius_, g.radius);
            entry.excess = std::fmax(entry.weight, nearest_weight(cluster, g)) * spread * spread;
        }
        add_to_heap(heap_, entry);
        weights_ += entry.weight;
        excess_ += entry.excess;
    }

    /// Whether noise() is above a bound. Mostly the running sums tell; their rounding may only
    /// divide one more entry.
    bool is_noisier_than(double bound) const {
        constexpr double surely = 1 + 1e-6;
        return excess_ > surely * bound * weights_ || noise() > bound;
    }

    /// The weight of one member of a cluster where the cluster is nearest. It may exceed that of
    /// the whole as seen from afar: a long row of lamps that begins at the cell.
    double nearest_weight(const LightCluster& cluster, const LightProxy& g) const {
        const Box box = tree_.box(cluster);
        const Vec3 v = glm::clamp(centre_, box.low, box.high) - centre_;
        const double weight =
            g.strength * g.radius / cluster.count / (dot(v, v) + radius_ * radius_);
        const Falloff* falloff = tree_.falloff(cluster);
        return falloff ? weight * against_square_law(*falloff, v, radius_) : weight;
    }

    const LightTree& tree_;
    Vec3 centre_;
    double radius_;
    std::vector<Entry> heap_;
    double weights_ = 0, excess_ = 0;  ///< of all entries, about
};

}  // namespace

double weight_in(const Box& cell, const LightTree& tree, const LightCluster& cluster) {
    return weight_around(cell.centre(), 0.5 * length(cell.size()), tree, cluster,
                         tree.light_proxy(cluster));
}

RefinedCut refined_cut(const LightTree& tree, const Box& cell, const CutRule& rule) {
    if (tree.lights() == 0) return {};
    Refinement refinement(tree, cell);
    refinement.refine(rule);
    RefinedCut result{{}, refinement.noise()};
    for (const Entry& entry : refinement.entries()) result.clusters.push_back(entry.cluster);
    return result;
}

}  // namespace candelabra
