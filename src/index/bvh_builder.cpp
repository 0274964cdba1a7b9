// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/bvh_builder.h"

#include "base/page_advice.h"
#include "base/parallel.h"
#include "base/short_list.h"
#include "base/single.h"
#include "index/split.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace {

/// Boxes with more items than this have their parts built side by side.
constexpr std::size_t fork_limit = 16384;
/// Who builds of so many items together keeps memory that is worth giving back.
constexpr std::uint32_t many_items = 16384;
/// Leaves have no more items than this.
constexpr std::size_t leaf_limit = 8;
/// Below so many levels items are halved, whatever it costs: the levels that are left do for all.
constexpr int careful_depth = Bvh::depth_limit - 12;
/// Boxes that are smaller than this share of their frame's begin a new one.
constexpr double least_reach = 0x1p-10;

/// What a ray that passes a box, and only asks whether anything is in its way, may expect there.
struct Prospect {
    double chance = 0;  ///< to be stopped
    double steps = 1;   ///< until that is known
};

/// A box and its items, which are side by side.
struct Part {
    enum class Kind { unknown, leaf, divided, halved };

    Box box;
    std::size_t first = 0, count = 0;
    Kind kind = Kind::unknown;
    Split split = {};  ///< of what is divided
    Prospect prospect = {};
    BvhChild child = BvhChild::leaf(0, 0);  ///< what it becomes
    std::uint32_t node = 0;                 ///< of what is no leaf

    bool inner() const { return kind == Kind::divided || kind == Kind::halved; }
};
using Parts = ShortList<Part, BvhNode::width>;

struct Task {
    BvhSettings costs;
    std::span<Fragment> fragments;  ///< whoever builds a part puts its fragments in order
    int threads;
};

/// The chance that a ray through a box is stopped by an item in it. What an item hides, its box
/// tells as much as is needed: the factor changes little.
double chance_to_stop(double item_area, double box_area) {
    return box_area > 0 ? std::min(1.0, 0.5 * item_area / box_area) : 1;
}

/// Puts the parts in the order in which rays that ask for anything in their way visit them, the
/// last one first: where a step stops them likeliest (Ize and Hansen, "RTSAH Traversal Order for
/// Occlusion Rays", 2011).
Prospect put_in_order(Parts& parts, const Box& box) {
    std::ranges::stable_sort(parts, [](const Part& a, const Part& b) {
        return a.prospect.chance * b.prospect.steps < b.prospect.chance * a.prospect.steps;
    });
    const double whole = area(box);
    double passing = 1;
    Prospect result;
    for (auto each = parts.rbegin(); each != parts.rend(); ++each) {
        const Part& part = *each;
        const double met = whole > 0 ? area(part.box) / whole : 1;
        result.steps += passing * met * part.prospect.steps;
        passing *= 1 - std::min(1.0, met) * part.prospect.chance;
    }
    result.chance = 1 - passing;
    return result;
}

/// The node of some parts, without children.
BvhNode node_around(const Parts& parts, const Vec3& origin) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    BvhNode node;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<int>(axis);
        node.low[axis].fill(infinity);
        node.high[axis].fill(-infinity);
        for (std::size_t slot = 0; slot < parts.size(); ++slot) {
            node.low[axis][slot] = rounded_down(parts[slot].box.low[at] - origin[at]);
            node.high[axis][slot] = rounded_up(parts[slot].box.high[at] - origin[at]);
        }
    }
    return node;
}

BvhFrame frame_around(const Box& box, std::uint32_t root) {
    return {box.centre(), 0.5 * max_component(box.size()), root};
}

/// The same where it and its children have moved up by so much.
BvhNode moved(BvhNode node, std::uint32_t nodes, std::uint32_t frames) {
    for (BvhChild& child : node.children) {
        if (child.is_leaf()) continue;
        child = child.is_frame() ? BvhChild::frame(child.frame() + frames)
                                 : BvhChild::node(child.node() + nodes);
    }
    return node;
}

/// Builds one part in a frame, which is the first one; nodes of one parent are side by side, before
/// those below them.
class Subtree {
public:
    Subtree(const Task& task, const Part& part, const BvhFrame& frame, int depth)
        : task_(task), nodes_(1), frames_{frame} {
        prospect_ = build(0, part, frame, depth);
    }

    const Prospect& prospect() const { return prospect_; }
    std::vector<BvhNode> take_nodes() { return std::move(nodes_); }
    std::vector<BvhFrame> take_frames() { return std::move(frames_); }

private:
    std::span<Fragment> fragments(const Part& part) const {
        return task_.fragments.subspan(part.first, part.count);
    }
    void decide(Part&, int depth) const;
    std::pair<Part, Part> halves(const Part&) const;
    Parts parts_of(const Part&, int depth) const;
    void finish_leaf(Part&) const;
    Prospect build(std::uint32_t node, const Part&, const BvhFrame&, int depth);
    void build_apart(std::span<Part>, const BvhFrame&, int depth);
    void adopt(const Part&, const Subtree&);
    /// The frame of a part with a node.
    const BvhFrame& frame_of(const Part&, const BvhFrame& outer) const;

    const Task& task_;
    std::vector<BvhNode> nodes_;
    std::vector<BvhFrame> frames_;
    Prospect prospect_;
};

/// Finds out what becomes of the part.
void Subtree::decide(Part& part, int depth) const {
    const bool fits = part.count <= leaf_limit;
    part.kind = fits ? Part::Kind::leaf : Part::Kind::halved;
    if (part.count <= 1 || depth >= careful_depth) return;
    part.split = find_split(fragments(part), part.box, task_.costs, !fits);
    if (part.split.found()) part.kind = Part::Kind::divided;
}

std::pair<Part, Part> Subtree::halves(const Part& part) const {
    const std::span<Fragment> all = fragments(part);
    Part below, above;
    if (part.kind == Part::Kind::divided) {
        const auto second = std::ranges::partition(
            all, [&](const Fragment& f) { return part.split.puts_below(f.box); });
        below.count = all.size() - second.size();
        below.box = part.split.below;
        above.box = part.split.above;
    } else {
        below.count = all.size() / 2;
        for (const Fragment& f : all.first(below.count)) below.box = join(below.box, f.box);
        for (const Fragment& f : all.subspan(below.count)) above.box = join(above.box, f.box);
    }
    below.first = part.first;
    above.first = part.first + below.count;
    above.count = part.count - below.count;
    return {below, above};
}

/// What becomes of a part that is divided: its halves, of which the largest one is divided as long
/// as there is room.
Parts Subtree::parts_of(const Part& whole, int depth) const {
    Parts parts{whole};
    for (;;) {
        Part* largest = nullptr;
        // Boxes may all be the same; and where parts are halved, only their number is sure to fall.
        const auto size = [&](const Part& part) {
            return std::pair(depth < careful_depth ? area(part.box) : 0, part.count);
        };
        for (Part& part : parts)
            if (part.kind != Part::Kind::leaf && (!largest || size(part) > size(*largest)))
                largest = &part;
        if (!largest) return parts;
        if (largest->kind == Part::Kind::unknown) {
            decide(*largest, depth);
            continue;
        }
        if (parts.size() == BvhNode::width) break;
        const auto [below, above] = halves(*largest);
        *largest = below;
        parts.push_back(above);
    }
    for (Part& part : parts)
        if (part.kind == Part::Kind::unknown) decide(part, depth);
    return parts;
}

/// Those who read leaves count on the order of items.
void Subtree::finish_leaf(Part& part) const {
    std::ranges::sort(fragments(part), {}, &Fragment::item);
    const double whole = area(part.box);
    double passing = 1;
    for (const Fragment& f : fragments(part)) passing *= 1 - chance_to_stop(area(f.box), whole);
    const auto items = static_cast<double>(part.count);
    part.prospect = {1 - passing, 1 + 2 * std::ceil(items / task_.costs.group)};
    part.child = BvhChild::leaf(static_cast<std::uint32_t>(part.first),
                                static_cast<std::uint32_t>(part.count));
}

Prospect Subtree::build(std::uint32_t node, const Part& whole, const BvhFrame& frame, int depth) {
    Parts parts = parts_of(whole, depth);
    // Parts that are nodes come first, as long as these are numbered.
    std::ranges::stable_partition(parts, &Part::inner);
    const auto count = static_cast<std::size_t>(std::ranges::count_if(parts, &Part::inner));
    const std::span<Part> inner(parts.data(), count);
    for (std::size_t i = count; i < parts.size(); ++i) finish_leaf(parts[i]);

    for (Part& part : inner) {
        const auto place = static_cast<std::uint32_t>(nodes_.size());
        part.child = BvhChild::node(place);
        part.node = place;
        nodes_.emplace_back();
        if (BvhFrame own = frame_around(part.box, place); own.reach < least_reach * frame.reach) {
            part.child = BvhChild::frame(static_cast<std::uint32_t>(frames_.size()));
            frames_.push_back(own);
        }
    }
    if (whole.count > fork_limit)
        build_apart(inner, frame, depth + 1);
    else
        for (Part& part : inner)
            part.prospect = build(part.node, part, BvhFrame(frame_of(part, frame)), depth + 1);
    const Prospect result = put_in_order(parts, whole.box);
    BvhNode made = node_around(parts, frame.origin);
    for (std::size_t slot = 0; slot < parts.size(); ++slot) made.children[slot] = parts[slot].child;
    nodes_[node] = made;
    return result;
}

const BvhFrame& Subtree::frame_of(const Part& part, const BvhFrame& outer) const {
    return part.child.is_frame() ? frames_[part.child.frame()] : outer;
}

/// Builds parts side by side, with the same result as one after the other: each apart, then
/// appended in order.
void Subtree::build_apart(std::span<Part> parts, const BvhFrame& frame, int depth) {
    std::vector<std::optional<Subtree>> made(parts.size());
    const std::function<void(std::size_t, std::size_t)> build_some = [&](std::size_t begin,
                                                                         std::size_t end) {
        if (end - begin == 1)
            made[begin].emplace(task_, parts[begin], frame_of(parts[begin], frame), depth);
        if (end - begin < 2) return;
        const std::size_t middle = (begin + end) / 2;
        run_both(
            task_.threads, [&] { build_some(begin, middle); }, [&] { build_some(middle, end); });
    };
    build_some(0, parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        parts[i].prospect = made[i]->prospect();
        adopt(parts[i], *made[i]);
        made[i].reset();
    }
}

/// Its first node and its first frame are there already.
void Subtree::adopt(const Part& part, const Subtree& other) {
    const auto nodes = static_cast<std::uint32_t>(nodes_.size() - 1);
    const auto frames = static_cast<std::uint32_t>(frames_.size() - 1);
    nodes_[part.node] = moved(other.nodes_[0], nodes, frames);
    for (std::size_t i = 1; i < other.nodes_.size(); ++i)
        nodes_.push_back(moved(other.nodes_[i], nodes, frames));
    for (std::size_t i = 1; i < other.frames_.size(); ++i) {
        frames_.push_back(other.frames_[i]);
        frames_.back().root += nodes;
    }
}

}  // namespace

/// Makes what only the hierarchy's owner may.
class BvhBuilder {
public:
    static Bvh make(std::vector<Fragment> fragments, const Box& bounds, const BvhSettings& settings,
                    int threads) {
        Bvh made;
        made.settings_ = settings;
        made.bounds_ = bounds;
        const Task task{settings, fragments, threads};
        std::optional<Subtree> tree;
        run_on_threads(threads, [&] {
            tree.emplace(task, Part{bounds, 0, fragments.size()}, frame_around(bounds, 0), 0);
        });
        made.nodes_ = tree->take_nodes();
        made.nodes_.shrink_to_fit();
        made.frames_ = tree->take_frames();
        made.items_.reserve(fragments.size());
        for (const Fragment& f : fragments) made.items_.push_back(f.item);
        choose_foremost(made, fragments, tree->prospect().steps);
        return made;
    }

private:
    /// Items that stop so many rays that asking them first spares more steps than it takes.
    static void choose_foremost(Bvh& made, std::span<const Fragment> fragments, double steps) {
        constexpr std::size_t most_leaves = 4;
        // A group in a row of others takes less than one alone.
        constexpr double cost = 0.5;
        const double whole = area(made.bounds_);
        std::vector<const Fragment*> largest;
        const auto larger = [](const Fragment* a, const Fragment* b) {
            return std::pair(area(a->box), b->item) > std::pair(area(b->box), a->item);
        };
        for (const Fragment& f : fragments)
            if (chance_to_stop(area(f.box), whole) * steps * leaf_limit > cost)
                largest.push_back(&f);
        std::ranges::sort(largest, larger);
        for (std::size_t leaf = 0; leaf < most_leaves && leaf * leaf_limit < largest.size();
             ++leaf) {
            const auto items = std::span(largest).subspan(
                leaf * leaf_limit, std::min(leaf_limit, largest.size() - leaf * leaf_limit));
            double chance = 0;
            for (const Fragment* f : items) chance += chance_to_stop(area(f->box), whole);
            if (chance * steps < cost) return;
            const std::size_t first = made.items_.size();
            for (const Fragment* f : items) made.items_.push_back(f->item);
            std::sort(made.items_.begin() + static_cast<std::ptrdiff_t>(first), made.items_.end());
            made.foremost_.push_back(BvhChild::leaf(static_cast<std::uint32_t>(first),
                                                    static_cast<std::uint32_t>(items.size())));
        }
    }
};

Bvh build_bvh(std::uint32_t items, const ItemBox& box_of, const BvhSettings& settings,
              int threads) {
    assert(items < Bvh::item_limit);
    std::vector<Fragment> fragments;
    fragments.reserve(items);
    Box bounds;
    for (std::uint32_t item = 0; item < items; ++item) {
        const Box box = box_of(item);
        if (box.empty()) continue;
        assert(finite(box));
        fragments.push_back({box, item});
        bounds = join(bounds, box);
    }
    if (fragments.empty()) return {};
    const double slack =
        0x1p-46 * std::max(max_abs_component(bounds.low), max_abs_component(bounds.high));
    const auto enlarge = [&](Box& box) { box = {box.low - Vec3(slack), box.high + Vec3(slack)}; };
    for (Fragment& f : fragments) enlarge(f.box);
    enlarge(bounds);
    Bvh made = BvhBuilder::make(std::move(fragments), bounds, settings, threads);
    if (items > many_items) give_back_freed();
    return made;
}
