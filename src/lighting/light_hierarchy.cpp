// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/light_hierarchy.h"

#include "base/elementary.h"
#include "base/order.h"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace candelabra {

namespace {

using std::numbers::pi;

constexpr int bins = 12;
/// Depth below which nodes are halved by number, so that luminaires in geometric progression do not
/// make an endless tree.
constexpr int halved_below = 64;
/// Nodes with more luminaires are only cut across their longest side: the axis matters little
/// there, but time does.
constexpr std::size_t many = 1u << 14;

/// Normals of flat luminaires around an axis, which has no sign because both sides emit.
struct Normals {
    Vec3 axis = Vec3(0);
    double spread = -1;  ///< radians; below 0: none yet; pi: luminaires that emit in all directions
};

Normals join(Normals a, Normals b) {
    if (a.spread < 0) return b;
    if (b.spread < 0) return a;
    if (a.spread < b.spread) std::swap(a, b);
    if (a.spread >= pi / 2) return {Vec3(0), pi};
    if (dot(a.axis, b.axis) < 0) b.axis = -b.axis;
    const Vec3 across = b.axis - dot(a.axis, b.axis) * a.axis;
    const double between = math::atan2(length(across), dot(a.axis, b.axis));
    if (between + b.spread <= a.spread) return a;
    const double spread = (a.spread + between + b.spread) / 2;
    if (spread >= pi / 2) return {Vec3(0), pi};
    const double turn = spread - a.spread;
    return {unit(math::cos(turn) * a.axis + math::sin(turn) * unit(across)), spread};
}

/// Solid angle into which luminaires with these normals emit, weighted by cosine (Conty Estevez and
/// Kulla, equation 1).
double orientation_measure(const Normals& normals) {
    if (normals.spread >= pi / 2) return 4 * pi;
    const double o = normals.spread, w = o + pi / 2;
    return 2 * pi * (1 - math::cos(o)) +
           pi / 2 *
               (2 * w * math::sin(o) - math::cos(o - 2 * w) - 2 * o * math::sin(o) + math::cos(o));
}

/// One or several luminaires.
struct Cluster {
    Box box;
    Normals normals;
    double intensity = 0;
};

Cluster join(const Cluster& a, const Cluster& b) {
    return {join(a.box, b.box), join(a.normals, b.normals), a.intensity + b.intensity};
}

double cost(const Cluster& c) {
    return c.intensity > 0 ? c.intensity * orientation_measure(c.normals) * area(c.box) : 0;
}

struct Split {
    double cost = std::numeric_limits<double>::infinity();
    int axis = -1;
    int bin = 0;  ///< first one of the second half
};

class Builder {
public:
    explicit Builder(std::span<const Luminaire> luminaires) : order_(luminaires.size()) {
        for (const Luminaire& luminaire : luminaires) {
            lights_.push_back(bounds(luminaire));
            const LightBounds& b = lights_.back();
            leaves_.push_back(
                {b.box, {b.axis, b.axis != Vec3(0) && b.evenness == 0 ? 0 : pi}, b.intensity});
        }
        std::iota(order_.begin(), order_.end(), LightIndex{0});
        nodes_.reserve(2 * luminaires.size());
    }

    std::vector<LightNode> build() {
        // The second half waits on the stack while the first is processed: children follow their
        // parents, depth first.
        std::vector<Work> waiting;
        if (!order_.empty()) waiting.push_back({0, order_.size(), 0, 0, false});
        while (!waiting.empty()) {
            const Work work = waiting.back();
            waiting.pop_back();
            const auto here = static_cast<std::uint32_t>(nodes_.size());
            nodes_.emplace_back();
            nodes_[here].parent = work.parent;
            if (work.second) nodes_[work.parent].second = here;
            if (work.end - work.first == 1) {
                nodes_[here].leaf = true;
                nodes_[here].second = order_[work.first];
                continue;
            }
            const std::size_t middle = divide(work);
            waiting.push_back({middle, work.end, here, work.depth + 1, true});
            waiting.push_back({work.first, middle, here, work.depth + 1, false});
        }
        fill_in();
        return std::move(nodes_);
    }

private:
    struct Work {
        std::size_t first, end;
        std::uint32_t parent;
        int depth;
        bool second;
    };

    int bin_of(LightIndex light, const Box& centres, int axis) const {
        const double place = (lights_[light].centre[axis] - centres.low[axis]) /
                             (centres.high[axis] - centres.low[axis]);
        return std::clamp(static_cast<int>(place * bins), 0, bins - 1);
    }

    void consider(const Work& work, const Box& centres, int axis, Split& best) const {
        std::array<Cluster, bins> bin;
        std::array<std::size_t, bins> count{};
        for (std::size_t i = work.first; i < work.end; ++i) {
            const int b = bin_of(order_[i], centres, axis);
            bin[b] = join(bin[b], leaves_[order_[i]]);
            ++count[b];
        }
        std::array<double, bins> upper{};
        Cluster behind;
        for (int b = bins - 1; b > 0; --b) {
            behind = join(behind, bin[b]);
            upper[b] = cost(behind);
        }
        // Cuts along a thin side make long slivers, so they cost more.
        const double slenderness = max_component(centres.size()) / centres.size()[axis];
        Cluster before;
        std::size_t below = 0;
        for (int b = 1; b < bins; ++b) {
            before = join(before, bin[b - 1]);
            below += count[b - 1];
            if (below == 0 || below == work.end - work.first) continue;
            const double sum = slenderness * (cost(before) + upper[b]);
            if (sum < best.cost) best = {sum, axis, b};
        }
    }

    /// Partitions the luminaires of a node. Returns the index of the first one of the second half.
    std::size_t divide(const Work& work) {
        Box centres;
        for (std::size_t i = work.first; i < work.end; ++i)
            centres = join(centres, lights_[order_[i]].centre);
        const Vec3 size = centres.size();
        const int longest = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(work.first);
        const auto end = order_.begin() + static_cast<std::ptrdiff_t>(work.end);
        Split best;
        if (work.depth < halved_below)
            for (int axis = 0; axis < 3; ++axis)
                if (size[axis] > 0 && (work.end - work.first <= many || axis == longest))
                    consider(work, centres, axis, best);
        if (best.axis >= 0) {
            const auto middle = std::stable_partition(begin, end, [&](LightIndex light) {
                return bin_of(light, centres, best.axis) < best.bin;
            });
            return static_cast<std::size_t>(middle - order_.begin());
        }
        const std::size_t half = (work.first + work.end) / 2;
        put_nth(begin, order_.begin() + static_cast<std::ptrdiff_t>(half), end,
                [&](LightIndex a, LightIndex b) {
                    const double x = lights_[a].centre[longest], y = lights_[b].centre[longest];
                    return x != y ? x < y : a < b;
                });
        return half;
    }

    /// Sets the properties of each node, from the leaves up.
    void fill_in() {
        std::vector<Cluster> clusters(nodes_.size());
        for (std::size_t i = nodes_.size(); i-- > 0;) {
            LightNode& node = nodes_[i];
            clusters[i] =
                node.leaf ? leaves_[node.second] : join(clusters[i + 1], clusters[node.second]);
            const Cluster& c = clusters[i];
            node.centre = node.leaf ? lights_[node.second].centre : c.box.centre();
            const double rounded =
                1e-15 * std::fmax(max_abs_component(c.box.low), max_abs_component(c.box.high));
            node.radius = node.leaf ? lights_[node.second].radius
                                    : 0.5 * length(c.box.size()) * (1 + 1e-12) + rounded;
            node.intensity = c.intensity;
            if (c.normals.spread >= pi / 2) continue;
            node.axis = glm::vec<3, float>(c.normals.axis);
            node.cos_spread = static_cast<float>(math::cos(c.normals.spread));
            node.sin_spread = static_cast<float>(math::sin(c.normals.spread));
        }
    }

    std::vector<LightBounds> lights_;
    std::vector<Cluster> leaves_;
    std::vector<LightIndex> order_;
    std::vector<LightNode> nodes_;
};

}  // namespace

std::vector<LightNode> build_light_hierarchy(std::span<const Luminaire> luminaires) {
    return Builder(luminaires).build();
}

}  // namespace candelabra
