// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/node_builder.h"

#include "base/order.h"
#include "base/parallel.h"
#include "base/round_outward.h"
#include "base/short_list.h"
#include "index/cell_split.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace candelabra {

namespace {

/// Number of items above which the parts of a box are built in parallel.
constexpr std::size_t fork_limit = 16384;
/// Depth from which on items are halved regardless of cost, so that the remaining levels suffice.
constexpr int careful_depth = WideTree::depth_limit - 12;
/// Boxes smaller than this fraction of their frame begin a new frame.
constexpr double min_reach = 0x1p-10;

/// Maximum number of references in cells, as a multiple of the number of items.
constexpr double max_references = 16;
/// What a cut costs of the allowance of each item in the cell. So cuts come to an end whatever the
/// items are: the sum of the allowances of all references in all cells begins at max_references per
/// item, no cut raises it, and a cut lowers it by this much for each item that it looks at. Hence
/// all cuts together look at no more than max_references / cut_price items for each item.
constexpr double cut_price = 1.0 / 128;
/// Maximum number of references in cells.
constexpr double references_limit = WideTree::item_limit / 2;

/// A box and its items.
struct Part {
    enum class Kind { unknown, leaf, cut, divided, halved };

    Box box = {};
    std::span<PrimRef> items = {};
    std::vector<PrimRef> own = {};      ///< of a cell: the storage of its items
    double allowance = max_references;  ///< of a cell: its remaining factor of references
    Kind kind = Kind::unknown;
    Split split = {};      ///< if divided
    CellSplit plane = {};  ///< if cut
    OcclusionCost prospect = {};
    TreeChild child = TreeChild::leaf(0);  ///< the reference to it
    std::uint32_t node = 0;                ///< if it is not a leaf

    bool inner() const { return kind != Kind::unknown && kind != Kind::leaf; }
};
using Parts = ShortList<Part, TreeNode::width>;

/// Sorts the parts by the order in which occlusion rays visit them, the last one first: by the
/// probability of occlusion per step (Ize and Hansen, "RTSAH Traversal Order for Occlusion Rays",
/// 2011).
OcclusionCost put_in_order(Parts& parts, const Box& box) {
    std::ranges::stable_sort(parts, [](const Part& a, const Part& b) {
        return a.prospect.chance * b.prospect.steps < b.prospect.chance * a.prospect.steps;
    });
    const double whole = area(box);
    double passing = 1;
    OcclusionCost result;
    for (auto each = parts.rbegin(); each != parts.rend(); ++each) {
        const Part& part = *each;
        const double met = whole > 0 ? area(part.box) / whole : 1;
        result.steps += passing * met * part.prospect.steps;
        passing *= 1 - std::min(1.0, met) * part.prospect.chance;
    }
    result.chance = 1 - passing;
    return result;
}

/// Returns a node with the boxes of some parts, without children.
TreeNode node_around(const Parts& parts, const Vec3& origin) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    TreeNode node;
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

TreeFrame frame_around(const Box& box, std::uint32_t root) {
    return {box.centre(), 0.5 * max_component(box.size()), root};
}

/// Moves the parts' items out for building; the original keeps its place and its box.
Part taken(Part& part) {
    Part result;
    result.box = part.box;
    result.items = part.items;
    result.own = std::move(part.own);
    result.allowance = part.allowance;
    result.kind = part.kind;
    result.split = part.split;
    result.plane = part.plane;
    return result;
}

/// Amounts of data before a part that was built separately.
struct Offset {
    std::uint32_t nodes, frames;
    std::size_t leaves;  ///< in words

    TreeChild of(TreeChild child) const {
        if (child.is_frame()) return TreeChild::frame(child.frame() + frames);
        if (child.is_node()) return TreeChild::node(child.node() + nodes);
        return TreeChild::leaf(child.leaf() + leaves);
    }
    TreeNode of(TreeNode node) const {
        for (TreeChild& child : node.children) child = of(child);
        return node;
    }
};

class NodeBuilder {
public:
    NodeBuilder(const NodeTask& task, bool cut) : task_(task), cut_(cut) {}

    /// Builds the nodes of a box at this depth.
    BuiltNodes build(Part, const TreeFrame&, int depth);

private:
    bool by_cells() const { return task_.costs.by == Division::cells; }
    void decide(Part&, int depth) const;
    std::pair<Part, Part> halves(Part&) const;
    std::optional<std::pair<Part, Part>> sides(const Part&) const;
    Parts parts_of(Part, int depth) const;
    void finish_leaf(Part&);
    OcclusionCost build(std::uint32_t node, Part, const TreeFrame&, int depth);
    void build_apart(std::span<Part>, const TreeFrame&, int depth);
    void adopt(const Part&, const BuiltNodes&);
    /// The frame of a part with a node.
    const TreeFrame& frame_of(const Part&, const TreeFrame& outer) const;

    const NodeTask& task_;
    bool cut_;  ///< whether the items are cut into pieces already
    BuiltNodes made_;
};

BuiltNodes NodeBuilder::build(Part whole, const TreeFrame& frame, int depth) {
    if (!by_cells() && task_.part && !cut_ && whole.items.size() <= fork_limit) {
        whole.own = pieces_of(whole.items, whole.box, task_.part, task_.slack);
        cut_ = !whole.own.empty();
        if (cut_) whole.items = whole.own;
    }
    made_.nodes.emplace_back();
    made_.frames.push_back(frame);
    made_.leaves.push_back(0);
    made_.prospect = build(0, std::move(whole), frame, depth);
    return std::move(made_);
}

/// Decides how the part is built.
void NodeBuilder::decide(Part& part, int depth) const {
    const bool fits = part.items.size() <= leaf_limit;
    part.kind = fits ? Part::Kind::leaf : Part::Kind::halved;
    if (part.items.size() <= 1 || depth >= careful_depth) return;
    if (by_cells()) {
        part.plane = {};
        if (part.allowance > 1)
            part.plane = find_cell_split(part.items, part.box, task_.costs, task_.slack);
        if (part.plane.found()) part.kind = Part::Kind::cut;
        if (fits || part.plane.found()) return;
    }
    part.split = find_split(part.items, part.box, task_.costs, !fits);
    if (part.split.found()) part.kind = Part::Kind::divided;
}

/// Divides the items in place.
std::pair<Part, Part> NodeBuilder::halves(Part& part) const {
    const std::span<PrimRef> all = part.items;
    Part below, above;
    std::size_t count = all.size() / 2;
    if (part.kind == Part::Kind::divided) {
        count = put_in_front(all, [&](const PrimRef& f) { return part.split.puts_below(f.box); });
        below.box = part.split.below;
        above.box = part.split.above;
    } else {
        for (const PrimRef& f : all.first(count)) below.box = join(below.box, f.box);
        for (const PrimRef& f : all.subspan(count)) above.box = join(above.box, f.box);
    }
    below.items = all.first(count);
    above.items = all.subspan(count);
    below.allowance = above.allowance = part.allowance;
    if (part.own.empty()) return {std::move(below), std::move(above)};
    above.own.assign(above.items.begin(), above.items.end());
    above.items = above.own;
    below.own = std::move(part.own);
    return {std::move(below), std::move(above)};
}

/// Divides the cell by its plane. Returns nothing if one side is the cell again, as where items are
/// as thin as the tolerance.
std::optional<std::pair<Part, Part>> NodeBuilder::sides(const Part& part) const {
    CellSides sides = divide(part.items, part.plane, task_.part, task_.slack);
    const std::size_t items = part.items.size();
    const auto is_whole = [&](const CellSide& side) {
        return side.fragments.size() == items && side.box.low == part.box.low &&
               side.box.high == part.box.high;
    };
    if (is_whole(sides.below) || is_whole(sides.above)) return {};
    const auto references = sides.below.fragments.size() + sides.above.fragments.size();
    const auto part_of = [&](CellSide& side) {
        Part made;
        made.box = side.box;
        made.own = std::move(side.fragments);
        made.items = made.own;
        made.allowance = (part.allowance - cut_price) * static_cast<double>(items) /
                         static_cast<double>(references);
        return made;
    };
    return std::pair(part_of(sides.below), part_of(sides.above));
}

/// Divides a part, and then its largest parts, until the node is full.
Parts NodeBuilder::parts_of(Part whole, int depth) const {
    Parts parts;
    parts.push_back(std::move(whole));
    for (;;) {
        Part* largest = nullptr;
        // Boxes may coincide, and where parts are halved, only the number of items is sure to
        // decrease.
        const auto size = [&](const Part& part) {
            return std::pair(depth < careful_depth ? area(part.box) : 0, part.items.size());
        };
        for (Part& part : parts)
            if (part.kind != Part::Kind::leaf && (!largest || size(part) > size(*largest)))
                largest = &part;
        if (!largest) return parts;
        if (largest->kind == Part::Kind::unknown) {
            decide(*largest, depth);
            continue;
        }
        if (parts.size() == TreeNode::width) break;
        auto cut = largest->kind == Part::Kind::cut ? sides(*largest) : halves(*largest);
        if (!cut) {
            largest->allowance = 0;
            largest->kind = Part::Kind::unknown;
            continue;
        }
        auto& [below, above] = *cut;
        // Items that pass through neither side are dropped.
        const bool any_below = !below.items.empty();
        *largest = std::move(any_below ? below : above);
        if (largest->items.empty())
            parts.erase(parts.begin() + (largest - parts.data()));
        else if (any_below && !above.items.empty())
            parts.push_back(std::move(above));
    }
    for (Part& part : parts)
        if (part.kind == Part::Kind::unknown) decide(part, depth);
    return parts;
}

/// Writes a leaf. Its readers rely on ascending items; pieces of one item are merged.
void NodeBuilder::finish_leaf(Part& part) {
    std::span<PrimRef> held = part.items;
    const double whole = area(part.box);
    double passing = 1;
    for (const PrimRef& f : held) passing *= 1 - chance_to_stop(area(f.box), whole);
    sort_stably(held, {}, &PrimRef::item);
    const auto end = std::unique(held.begin(), held.end(), [](const PrimRef& a, const PrimRef& b) {
        return a.item == b.item;
    });
    held = held.first(static_cast<std::size_t>(end - held.begin()));
    part.child = TreeChild::leaf(made_.leaves.size());
    made_.leaves.push_back(static_cast<std::uint32_t>(held.size()));
    for (const PrimRef& f : held) made_.leaves.push_back(f.item);
    part.prospect = {1 - passing,
                     1 + 2 * std::ceil(static_cast<double>(held.size()) / task_.costs.group)};
}

OcclusionCost NodeBuilder::build(std::uint32_t node, Part whole, const TreeFrame& frame,
                                 int depth) {
    const Box box = whole.box;
    const bool many = whole.items.size() > fork_limit;
    Parts parts = parts_of(std::move(whole), depth);
    // Inner parts come first while they are numbered.
    std::stable_partition(parts.begin(), parts.end(),
                          [](const Part& part) { return part.inner(); });
    const auto count = static_cast<std::size_t>(std::ranges::count_if(parts, &Part::inner));
    const std::span<Part> inner(parts.data(), count);
    for (std::size_t i = count; i < parts.size(); ++i) finish_leaf(parts[i]);

    for (Part& part : inner) {
        const auto place = static_cast<std::uint32_t>(made_.nodes.size());
        part.child = TreeChild::node(place);
        part.node = place;
        made_.nodes.emplace_back();
        if (TreeFrame own = frame_around(part.box, place); own.reach < min_reach * frame.reach) {
            part.child = TreeChild::frame(static_cast<std::uint32_t>(made_.frames.size()));
            made_.frames.push_back(own);
        }
    }
    if (many)
        build_apart(inner, frame, depth + 1);
    else
        for (Part& part : inner)
            part.prospect =
                build(part.node, taken(part), TreeFrame(frame_of(part, frame)), depth + 1);
    const OcclusionCost result = put_in_order(parts, box);
    TreeNode made = node_around(parts, frame.origin);
    for (std::size_t slot = 0; slot < parts.size(); ++slot) made.children[slot] = parts[slot].child;
    made_.nodes[node] = made;
    return result;
}

const TreeFrame& NodeBuilder::frame_of(const Part& part, const TreeFrame& outer) const {
    return part.child.is_frame() ? made_.frames[part.child.frame()] : outer;
}

/// Builds parts in parallel, with the same result as sequentially: each separately, then appended
/// in order.
void NodeBuilder::build_apart(std::span<Part> parts, const TreeFrame& frame, int depth) {
    std::vector<BuiltNodes> built(parts.size());
    const std::function<void(std::size_t, std::size_t)> build_some = [&](std::size_t begin,
                                                                         std::size_t end) {
        if (end - begin == 1) {
            Part& part = parts[begin];
            built[begin] =
                NodeBuilder(task_, cut_).build(taken(part), frame_of(part, frame), depth);
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

/// Appends a separately built part, whose first node and first frame exist already.
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

BuiltNodes build_nodes(const NodeTask& task, std::span<PrimRef> fragments, const Box& box) {
    Part whole;
    whole.box = box;
    whole.items = fragments;
    whole.allowance =
        std::min(max_references, references_limit / static_cast<double>(fragments.size()));
    return NodeBuilder(task, false).build(std::move(whole), frame_around(box, 0), 0);
}

}  // namespace candelabra
