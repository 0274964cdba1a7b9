// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/node_builder.h"

#include "base/parallel.h"
#include "base/short_list.h"
#include "base/single.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace {

/// Boxes with more items than this have their parts built side by side.
constexpr std::size_t fork_limit = 16384;
/// Below so many levels items are halved, whatever it costs: the levels that are left do for all.
constexpr int careful_depth = Bvh::depth_limit - 12;
/// Boxes that are smaller than this share of their frame's begin a new one.
constexpr double least_reach = 0x1p-10;

/// A box and its items, which are side by side.
struct Part {
    enum class Kind { unknown, leaf, divided, halved };

    Box box;
    std::size_t first = 0, count = 0;
    Kind kind = Kind::unknown;
    Split split = {};  ///< of what is divided
    Prospect prospect = {};
    BvhChild child = BvhChild::leaf(0);  ///< what it becomes
    std::uint32_t node = 0;              ///< of what is no leaf

    bool inner() const { return kind == Kind::divided || kind == Kind::halved; }
};
using Parts = ShortList<Part, BvhNode::width>;

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

/// So much of everything comes before what has been built apart.
struct Offset {
    std::uint32_t nodes, frames;
    std::size_t leaves;  ///< in words

    BvhChild of(BvhChild child) const {
        if (child.is_frame()) return BvhChild::frame(child.frame() + frames);
        if (child.is_node()) return BvhChild::node(child.node() + nodes);
        return BvhChild::leaf(child.leaf() + leaves);
    }
    BvhNode of(BvhNode node) const {
        for (BvhChild& child : node.children) child = of(child);
        return node;
    }
};

class NodeBuilder {
public:
    NodeBuilder(const NodeTask& task, std::span<Fragment> fragments, bool cut)
        : task_(task), fragments_(fragments), cut_(cut) {}

    /// What is in a box, which begins so many levels deep.
    BuiltNodes build(const Box&, const BvhFrame&, int depth);

private:
    std::span<Fragment> fragments(const Part& part) const {
        return fragments_.subspan(part.first, part.count);
    }
    void decide(Part&, int depth) const;
    std::pair<Part, Part> halves(const Part&) const;
    Parts parts_of(const Part&, int depth) const;
    void finish_leaf(Part&);
    Prospect build(std::uint32_t node, const Part&, const BvhFrame&, int depth);
    void build_apart(std::span<Part>, const BvhFrame&, int depth);
    void adopt(const Part&, const BuiltNodes&);
    /// The frame of a part with a node.
    const BvhFrame& frame_of(const Part&, const BvhFrame& outer) const;

    const NodeTask& task_;
    std::vector<Fragment> pieces_;   ///< the fragments, if they are cut
    std::span<Fragment> fragments_;  ///< those of a part are side by side
    bool cut_;                       ///< the fragments are pieces already
    BuiltNodes made_;
};

BuiltNodes NodeBuilder::build(const Box& box, const BvhFrame& frame, int depth) {
    if (task_.part && !cut_ && fragments_.size() <= fork_limit) {
        pieces_ = pieces_of(fragments_, box, task_.part, task_.slack);
        if (!pieces_.empty()) {
            fragments_ = pieces_;
            cut_ = true;
        }
    }
    made_.nodes.emplace_back();
    made_.frames.push_back(frame);
    made_.leaves.push_back(0);
    made_.prospect = build(0, Part{box, 0, fragments_.size()}, frame, depth);
    return std::move(made_);
}

/// Finds out what becomes of the part.
void NodeBuilder::decide(Part& part, int depth) const {
    const bool fits = part.count <= leaf_limit;
    part.kind = fits ? Part::Kind::leaf : Part::Kind::halved;
    if (part.count <= 1 || depth >= careful_depth) return;
    part.split = find_split(fragments(part), part.box, task_.costs, !fits);
    if (part.split.found()) part.kind = Part::Kind::divided;
}

std::pair<Part, Part> NodeBuilder::halves(const Part& part) const {
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
Parts NodeBuilder::parts_of(const Part& whole, int depth) const {
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

/// Those who read leaves count on the order of items. Pieces of one item are one again.
void NodeBuilder::finish_leaf(Part& part) {
    std::span<Fragment> held = fragments(part);
    const double whole = area(part.box);
    double passing = 1;
    for (const Fragment& f : held) passing *= 1 - chance_to_stop(area(f.box), whole);
    std::ranges::sort(held, {}, &Fragment::item);
    held = held.first(held.size() - std::ranges::unique(held, {}, &Fragment::item).size());
    part.child = BvhChild::leaf(made_.leaves.size());
    made_.leaves.push_back(static_cast<std::uint32_t>(held.size()));
    for (const Fragment& f : held) made_.leaves.push_back(f.item);
    part.prospect = {1 - passing,
                     1 + 2 * std::ceil(static_cast<double>(held.size()) / task_.costs.group)};
}

Prospect NodeBuilder::build(std::uint32_t node, const Part& whole, const BvhFrame& frame,
                            int depth) {
    Parts parts = parts_of(whole, depth);
    // Parts that are nodes come first, as long as these are numbered.
    std::ranges::stable_partition(parts, &Part::inner);
    const auto count = static_cast<std::size_t>(std::ranges::count_if(parts, &Part::inner));
    const std::span<Part> inner(parts.data(), count);
    for (std::size_t i = count; i < parts.size(); ++i) finish_leaf(parts[i]);

    for (Part& part : inner) {
        const auto place = static_cast<std::uint32_t>(made_.nodes.size());
        part.child = BvhChild::node(place);
        part.node = place;
        made_.nodes.emplace_back();
        if (BvhFrame own = frame_around(part.box, place); own.reach < least_reach * frame.reach) {
            part.child = BvhChild::frame(static_cast<std::uint32_t>(made_.frames.size()));
            made_.frames.push_back(own);
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
    made_.nodes[node] = made;
    return result;
}

const BvhFrame& NodeBuilder::frame_of(const Part& part, const BvhFrame& outer) const {
    return part.child.is_frame() ? made_.frames[part.child.frame()] : outer;
}

/// Builds parts side by side, with the same result as one after the other: each apart, then
/// appended in order.
void NodeBuilder::build_apart(std::span<Part> parts, const BvhFrame& frame, int depth) {
    std::vector<BuiltNodes> built(parts.size());
    const std::function<void(std::size_t, std::size_t)> build_some = [&](std::size_t begin,
                                                                         std::size_t end) {
        if (end - begin == 1) {
            const Part& part = parts[begin];
            built[begin] = NodeBuilder(task_, fragments(part), cut_)
                               .build(part.box, frame_of(part, frame), depth);
        }
        if (end - begin < 2) return;
        const std::size_t middle = (begin + end) / 2;
        run_both(
            task_.threads, [&] { build_some(begin, middle); }, [&] { build_some(middle, end); });
    };
    build_some(0, parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        parts[i].prospect = built[i].prospect;
        adopt(parts[i], built[i]);
        built[i] = {};
    }
}

/// Its first node and its first frame are there already.
void NodeBuilder::adopt(const Part& part, const BuiltNodes& other) {
    const Offset up{static_cast<std::uint32_t>(made_.nodes.size() - 1),
                    static_cast<std::uint32_t>(made_.frames.size() - 1), made_.leaves.size()};
    made_.nodes[part.node] = up.of(other.nodes[0]);
    for (std::size_t i = 1; i < other.nodes.size(); ++i)
        made_.nodes.push_back(up.of(other.nodes[i]));
    for (std::size_t i = 1; i < other.frames.size(); ++i) {
        made_.frames.push_back(other.frames[i]);
        made_.frames.back().root += up.nodes;
    }
    made_.leaves.insert(made_.leaves.end(), other.leaves.begin(), other.leaves.end());
}

}  // namespace

double chance_to_stop(double item_area, double box_area) {
    return box_area > 0 ? std::min(1.0, 0.5 * item_area / box_area) : 1;
}

BuiltNodes build_nodes(const NodeTask& task, std::span<Fragment> fragments, const Box& box) {
    return NodeBuilder(task, fragments, false).build(box, frame_around(box, 0), 0);
}
