// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/light_hierarchy.h"

#include "base/elementary.h"
#include "lighting/hierarchy_builder.h"
#include "lighting/opposed_axes.h"
#include "lighting/tuning.h"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace candelabra {

namespace {

using std::numbers::pi;

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
    if (are_opposed(a.axis, b.axis)) b.axis = -b.axis;
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

/// The surface area orientation heuristic.
struct OrientationCost {
    using Item = LightIndex;
    using Number = double;
    using Sum = Cluster;
    static constexpr int bins = tuning::light_bvh.bins;
    static constexpr std::size_t many = tuning::light_bvh.many;

    std::span<const LightBounds> lights;
    std::span<const Cluster> leaves;

    double place(LightIndex light, int axis) const { return lights[light].centre[axis]; }
    static LightIndex light(LightIndex light) { return light; }
    static int bin(double from_low, double size) {
        return static_cast<int>(from_low / size * bins);
    }
    void add(Sum& sum, LightIndex light) const { sum = join(sum, leaves[light]); }
    static void add(Sum& sum, const Cluster& part) { sum = join(sum, part); }
    static double of(const Sum& c) {
        return c.intensity > 0 ? c.intensity * orientation_measure(c.normals) * area(c.box) : 0;
    }
    static bool longer(double later, double earlier) { return later >= earlier; }
    /// Cuts along a thin side make long slivers, so they cost more.
    static double of_side(double longest, double size) { return longest / size; }
    static bool is_second_kind(const Item&) { return false; }
};

/// Sets the properties of each node, from the leaves up.
void fill_in(std::vector<LightNode>& nodes, std::span<const LightBounds> lights,
             std::span<const Cluster> leaves) {
    std::vector<Cluster> clusters(nodes.size());
    for (std::size_t i = nodes.size(); i-- > 0;) {
        LightNode& node = nodes[i];
        if (!node.leaf)
            nodes[i + 1].parent = nodes[node.second].parent = static_cast<std::uint32_t>(i);
        clusters[i] =
            node.leaf ? leaves[node.second] : join(clusters[i + 1], clusters[node.second]);
        const Cluster& c = clusters[i];
        node.centre = node.leaf ? lights[node.second].centre : c.box.centre();
        const double rounded =
            1e-15 * std::fmax(max_abs_component(c.box.low), max_abs_component(c.box.high));
        node.radius = node.leaf ? lights[node.second].radius
                                : 0.5 * length(c.box.size()) * (1 + 1e-12) + rounded;
        node.intensity = c.intensity;
        if (c.normals.spread >= pi / 2) continue;
        node.axis = glm::vec<3, float>(c.normals.axis);
        node.cos_spread = static_cast<float>(math::cos(c.normals.spread));
        node.sin_spread = static_cast<float>(math::sin(c.normals.spread));
    }
}

}  // namespace

std::vector<LightNode> build_light_hierarchy(const ChoosableLights& choosable, int threads) {
    std::vector<LightBounds> lights;
    std::vector<Cluster> leaves;
    std::vector<LightIndex> order(choosable.size());
    std::iota(order.begin(), order.end(), LightIndex{0});
    for (const LightIndex light : order) {
        const LightBounds b = choosable.bounds(light);
        lights.push_back(b);
        leaves.push_back(
            {b.box, {b.axis, b.axis != Vec3(0) && b.evenness == 0 ? 0 : pi}, b.intensity});
    }
    std::vector<LightNode> nodes(order.empty() ? 0 : 2 * order.size() - 1);
    HierarchyBuilder<OrientationCost> builder(std::move(order), {lights, leaves});
    builder.build(
        threads, [&](std::size_t own, std::size_t first, std::size_t middle, std::size_t end) {
            LightNode& node = nodes[own];
            node.leaf = middle == end;
            node.second = node.leaf ? builder.items()[first]
                                    : static_cast<std::uint32_t>(own + 2 * (middle - first));
        });
    fill_in(nodes, lights, leaves);
    return nodes;
}

}  // namespace candelabra
