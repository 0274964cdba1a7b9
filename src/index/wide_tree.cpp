// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/wide_tree.h"

#include "base/lanes.h"
#include "base/memory_pages.h"
#include "base/parallel.h"
#include "base/target_clones.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <utility>

namespace candelabra {

namespace {

/// Upper bound, with some margin, of the relative error of rounding to single precision.
constexpr double rounding = 0x1p-22;

float below(double x) {
    const auto f = static_cast<float>(x);
    return f - static_cast<float>(rounding) * std::abs(f);
}
float above(double x) {
    const auto f = static_cast<float>(x);
    return f + static_cast<float>(rounding) * std::abs(f);
}

/// A ray relative to a frame. t is in units of the ray's greatest step along an axis, so that its
/// magnitude is that of coordinates.
class Probe {
public:
    [[gnu::always_inline]] Probe(const TreeFrame& frame, const Ray& ray, const Interval& range) {
        const Vec3& d = ray.direction;
        const Vec3 size = glm::abs(d);
        unit_ = size.x > size.y ? size.x : size.y;
        unit_ = size.z > unit_ ? size.z : unit_;
        per_unit_ = 1 / unit_;
        const FourDoubles steps{d.x, d.y, d.z, 1};
        FourDoubles inverse = unit_ / steps;
        // Planes parallel to the ray count as very distant, on the side where they are: further
        // than anything that the ray could meet.
        constexpr double along = 1e30;
        inverse = inverse > along ? FourDoubles{} + along : inverse;
        inverse = inverse < -along ? FourDoubles{} - along : inverse;

        Vec3 from = ray.origin - frame.origin;
        double lost = 0x1p-146;  // for the smallest numbers of single precision
        // A distant origin is moved along the ray to near the frame.
        if (const double distance = max_abs(from); distance > far_away * frame.reach) {
            skipped_ = -dot(from, d) / dot(d, d);
            from += skipped_ * d;
            lost += 0x1p-50 * distance;
        }
        // Distances have a relative error, and the origin has that of single precision. Both
        // enlarge boxes: near planes move nearer, and far ones further. The signs are those for t
        // above 0; a range that begins behind the origin gets a larger error to make up for it.
        const double least = (range.min - skipped_) * unit_;
        if (least < 0) lost += 4 * rounding * (frame.reach + max_abs(from));
        const FourDoubles origin{from.x, from.y, from.z, 0};
        FourDoubles error = (origin < 0 ? -origin : origin) * rounding + lost;
        error = inverse < 0 ? -error : error;
        const Four near = __builtin_convertvector(origin + error, Four);
        const Four far = __builtin_convertvector(origin - error, Four);
        const Four sooner = __builtin_convertvector(inverse * (1 - rounding), Four);
        const Four later = __builtin_convertvector(inverse * (1 + rounding), Four);
#pragma GCC unroll 3
        for (int axis = 0; axis < 3; ++axis) {
            const auto at = static_cast<std::size_t>(axis);
            near_[at] = lanes_of(near[axis]);
            far_[at] = lanes_of(far[axis]);
            sooner_[at] = lanes_of(sooner[axis]);
            later_[at] = lanes_of(later[axis]);
            const std::size_t row = at * sizeof(TreeNode::Row);
            first_[at] = offsetof(TreeNode, low) + row;
            last_[at] = offsetof(TreeNode, high) + row;
            if (std::signbit(d[axis])) std::swap(first_[at], last_[at]);
        }
        least_ = below(least);
        set_end(range);
    }

    void set_end(const Interval& range) { most_ = above((range.max - skipped_) * unit_); }
    float begin() const { return least_; }
    bool beyond(float t) const { return t > most_; }
    /// Parameter along the original ray.
    double parameter(float t) const { return skipped_ + t * per_unit_; }

    /// Returns a bit for each slot whose box the ray meets, and the entry parameter of every slot.
    /// NaN rules out no box.
    [[gnu::always_inline]] std::uint32_t meet(const TreeNode& node, Lanes& entry) const {
        const auto* const bytes = reinterpret_cast<const std::byte*>(&node);
        std::array<Lanes, 3> in, out;
#pragma GCC unroll 3
        for (std::size_t axis = 0; axis < 3; ++axis) {
            in[axis] = (load_lanes(bytes + first_[axis]) - near_[axis]) * sooner_[axis];
            out[axis] = (load_lanes(bytes + last_[axis]) - far_[axis]) * later_[axis];
        }
        // The second operand is the result if the first one is NaN.
        entry = greatest_of(greatest_of(in[0], in[1]), greatest_of(in[2], lanes_of(least_)));
        const Lanes exit = min_of(min_of(out[0], out[1]), min_of(out[2], lanes_of(most_)));
        return marked(~(entry > exit));
    }

private:
    using Four [[gnu::vector_size(4 * sizeof(float))]] = float;
    using FourDoubles [[gnu::vector_size(4 * sizeof(double))]] = double;
    static constexpr double far_away = 64;  ///< in units of the frame's reach

    static double max_abs(const Vec3& v) {
        const Vec3 size = glm::abs(v);
        const double most = size.x > size.y ? size.x : size.y;
        return size.z > most ? size.z : most;
    }

    double unit_, per_unit_;                   ///< from the ray's parameter to t, and back
    double skipped_ = 0;                       ///< the ray's parameter at t = 0
    std::array<Lanes, 3> near_, far_;          ///< the origin, for near and far planes
    std::array<Lanes, 3> sooner_, later_;      ///< the inverse direction, for near and far planes
    std::array<std::size_t, 3> first_, last_;  ///< offsets of the near and far ends in a node
    float least_, most_;
};

/// A child still to be visited.
struct Pending {
    float entry;
    TreeChild child;
};

/// Returns the child in `slots` to visit first, and pushes the others onto the stack.
template <bool likely_first>
[[gnu::always_inline]] inline Pending take_first(const TreeNode& node, std::uint32_t slots,
                                                 const Lanes& entry, Pending*& top) {
    const auto take_lowest = [&] {
        const int slot = std::countr_zero(slots);
        slots &= slots - 1;
        return Pending{entry[slot], node.children[static_cast<std::size_t>(slot)]};
    };
    Pending next = take_lowest();
    if constexpr (likely_first) {
        // Likelier children have higher slots.
        for (; slots != 0; next = take_lowest()) *top++ = next;
    } else if (slots != 0) {
        Pending* const first = top;
        for (*top++ = next; slots != 0;) {
            next = take_lowest();
            Pending* place = top++;
            for (; place > first && place[-1].entry < next.entry; --place) *place = place[-1];
            *place = next;
        }
        next = *--top;
    }
    return next;
}

}  // namespace

template <bool likely_first>
[[gnu::always_inline]] inline bool WideTree::walk_any(const TreeFrame& frame, const Ray& ray,
                                                      Interval& range, Visit visit) const {
    Probe probe(frame, ray, range);
    std::array<Pending, (TreeNode::width - 1) * depth_limit + 1> stack;
    Pending* top = stack.data();
    const auto* const nodes = reinterpret_cast<const std::byte*>(nodes_.data());
    Pending here{probe.begin(), TreeChild::node(frame.root)};
    for (;;) {
        if (here.child.is_node()) {
            const auto& node = *reinterpret_cast<const TreeNode*>(nodes + here.child.node_place());
            Lanes entry;
            if (const std::uint32_t slots = probe.meet(node, entry)) {
                here = take_first<likely_first>(node, slots, entry, top);
                continue;
            }
        } else if (here.child.is_leaf()) {
            const TreeLeaf met = leaf(here.child, probe.parameter(here.entry));
            if (!met.items.empty() && visit(met, range)) return true;
            if (!likely_first) probe.set_end(range);
        } else {
            const TreeFrame& inner = frames_[here.child.frame()];
            if (likely_first ? walk_likely(inner, ray, range, visit)
                             : walk(inner, ray, range, visit))
                return true;
            if (!likely_first) probe.set_end(range);
        }
        do {
            if (top == stack.data()) return false;
            here = *--top;
        } while (!likely_first && probe.beyond(here.entry));
    }
}

CANDELABRA_TARGET_CLONES bool WideTree::walk(const TreeFrame& frame, const Ray& ray,
                                             Interval& range, Visit visit) const {
    return walk_any<false>(frame, ray, range, visit);
}

CANDELABRA_TARGET_CLONES bool WideTree::walk_likely(const TreeFrame& frame, const Ray& ray,
                                                    Interval& range, Visit visit) const {
    return walk_any<true>(frame, ray, range, visit);
}

bool WideTree::visit_foremost(const Ray& ray, Interval& range, Visit visit) const {
    if (foremost_.empty()) return false;
    // The point nearest to the centre of the bounds; only few rays wait for this division.
    double entry = 0;
    if (!contains(bounds_, ray.origin)) {
        const double length2 = dot(ray.direction, ray.direction);
        entry = dot(bounds_.centre() - ray.origin, ray.direction);
        if (!(std::abs(length2 - 1) < 0x1p-30)) entry /= length2;
    }
    return std::ranges::any_of(foremost_,
                               [&](TreeChild child) { return visit(leaf(child, entry), range); });
}

bool WideTree::visit_endless(Interval& range, Visit visit) const {
    // In groups as large as a leaf.
    for (std::size_t first = 0; first < endless_.size(); first += TreeNode::width) {
        const std::size_t count = std::min(TreeNode::width, endless_.size() - first);
        if (visit({std::span(endless_).subspan(first, count), nullptr, range.min}, range))
            return true;
    }
    return false;
}

std::span<const std::uint32_t> WideTree::items(TreeChild child) const {
    return leaf(child, 0).items;
}

std::size_t WideTree::memory_bytes() const {
    return sizeof(*this) + frames_.capacity() * sizeof(TreeFrame) +
           nodes_.capacity() * sizeof(TreeNode) +
           (leaves_.capacity() + packs_.size() + endless_.capacity()) * sizeof(std::uint32_t);
}

void WideTree::pack(const LeafPacks& packs, int threads) {
    struct Leaf {
        std::span<const std::uint32_t> items;
        Box box;
        std::size_t place;
    };
    std::vector<Leaf> leaves;
    std::size_t words = 4;  // of leaves without items
    const auto add = [&](TreeChild& child, const Box& box) {
        const auto list = items(child);
        leaves.push_back({list, box, words});
        const std::size_t size = 1 + list.size() + packs.size(list);
        child = TreeChild::leaf(words / 4);
        words += (size + 3) / 4 * 4;
    };
    for_each_node([&](std::uint32_t number, const TreeFrame& frame, int) {
        TreeNode& node = nodes_[number];
        for (std::size_t slot = 0; slot < TreeNode::width; ++slot)
            if (node.used(slot) && node.children[slot].is_leaf())
                add(node.children[slot], node.box(slot, frame.origin));
    });
    for (TreeChild& child : foremost_) add(child, bounds_);

    // Vectorised readers of packs may read beyond the end of the last one.
    words += 2 * lane_count;
    std::vector<std::uint32_t> made;
    made.reserve(words);
    expect_huge_pages(made.data(), words * sizeof(std::uint32_t));
    made.resize(words);
    constexpr std::size_t portion = 4096;
    run_parallel((leaves.size() + portion - 1) / portion, threads, [&](std::size_t part) {
        const std::size_t end = std::min(leaves.size(), (part + 1) * portion);
        for (std::size_t i = part * portion; i < end; ++i) {
            const auto& [list, box, place] = leaves[i];
            const std::size_t size = packs.size(list);
            made[place] = static_cast<std::uint32_t>(list.size());
            std::ranges::copy(list, made.begin() + static_cast<std::ptrdiff_t>(place) + 1);
            packs.fill(list, box, std::span(made).subspan(place + 1 + list.size(), size));
        }
    });
    packs_ = std::move(made);
    std::vector<std::uint32_t>().swap(leaves_);
    use_huge_pages(nodes_.data(), nodes_.size() * sizeof(TreeNode));
    use_huge_pages(packs_.data(), packs_.size() * sizeof(std::uint32_t));
}

void WideTree::for_each_node(
    FunctionRef<void(std::uint32_t number, const TreeFrame&, int depth)> use) const {
    struct Place {
        std::uint32_t node, frame;
        int depth;
    };
    std::vector<Place> todo;
    if (!frames_.empty()) todo.push_back({frames_[0].root, 0, 1});
    while (!todo.empty()) {
        const Place place = todo.back();
        todo.pop_back();
        use(place.node, frames_[place.frame], place.depth);
        const TreeNode& node = nodes_[place.node];
        for (std::size_t slot = TreeNode::width; slot-- > 0;) {
            const TreeChild child = node.children[slot];
            if (!node.used(slot) || child.is_leaf()) continue;
            const std::uint32_t frame = child.is_frame() ? child.frame() : place.frame;
            const std::uint32_t next = child.is_frame() ? frames_[frame].root : child.node();
            todo.push_back({next, frame, place.depth + 1});
        }
    }
}

}  // namespace candelabra
