// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/kdtree.h"

#include "index/split.h"

#include "base/page_advice.h"
#include "base/parallel.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

namespace {

/// Cells with more fragments than this have their halves built side by side.
constexpr std::size_t fork_limit = 16384;
/// Who builds of so many items together keeps memory that is worth giving back.
constexpr std::uint32_t many_items = 16384;
/// Packs of leaves are tested by so many items at once.
constexpr double group_size = 8;

struct Task {
    const ClipItem& clip_item;
    KdTreeSettings settings;
    double slack;
    int threads;
};

Box grown(const Box& box, double by) { return {box.low - Vec3(by), box.high + Vec3(by)}; }

/// What a ray that passes a cell, and only asks whether anything is in its way, may expect there.
struct Prospect {
    double chance;  ///< to be stopped
    double steps;   ///< until that is known
};

/// What rays may expect where items are tested in groups. Of what an item hides, its box tells as
/// much as is needed: the factor changes little.
Prospect prospect(std::span<const Fragment> fragments, const Box& cell) {
    double passing = 1;
    for (const Fragment& f : fragments)
        passing *= 1 - std::min(1.0, 0.5 * area(f.box) / area(cell));
    const double groups = std::ceil(static_cast<double>(fragments.size()) / group_size);
    return {passing < 1 ? 1 - passing : 0, 1 + 2 * groups};
}

/// Of a cell and its halves. Rays begin where a step stops them likeliest (Ize and Hansen, "RTSAH
/// Traversal Order for Occlusion Rays", 2011), unless the halves differ so little that the nearer
/// one is as good: measured, the meshes of even surfaces lose by any other order.
struct Order {
    KdNode::Half likely = KdNode::Half::neither;
    Prospect whole;

    Order(const Box& cell, const std::pair<Box, Box>& cells, Prospect below, Prospect above) {
        constexpr double even = 1.5;
        const double for_above = above.chance * below.steps, for_below = below.chance * above.steps;
        if (for_above > even * for_below) likely = KdNode::Half::above;
        if (for_below > even * for_above) likely = KdNode::Half::below;
        double first = area(cells.first) / area(cell), second = area(cells.second) / area(cell);
        if (for_above > for_below) {
            std::swap(below, above);
            std::swap(first, second);
        }
        const double past_first = 1 - first * below.chance;
        whole.chance = 1 - past_first * (1 - second * above.chance);
        whole.steps = 1 + first * below.steps + past_first * second * above.steps;
    }
};

/// How far a cell may still be divided.
struct Allowance {
    int depth;
    double duplication;  ///< factor by which the number of fragments may still grow
};

/// Builds one subtree. Its root is node 0, alone; then come pairs of children, each before the
/// pairs below it. Fragments wait on a stack: those of the cell in hand are on top, below them
/// those of the upper halves still to do.
class Subtree {
public:
    Subtree(const Task& task, std::vector<Fragment> fragments, const Box& cell, Allowance allowance)
        : task_(task),
          fragments_(std::move(fragments)),
          finder_({task.settings.traversal_cost, task.settings.intersection_cost,
                   task.settings.empty_bonus, group_size},
                  task.slack) {
        nodes_.push_back(KdNode::leaf(0, 0));
        prospect_ = build(0, 0, cell, allowance);
    }

    const Prospect& prospect() const { return prospect_; }

    std::vector<KdNode> take_nodes() { return std::move(nodes_); }
    std::vector<std::uint32_t> take_items() { return std::move(items_); }

private:
    struct Sides {
        Box below, above;
    };
    struct Halves {
        std::vector<Fragment> below, above;
        std::size_t size() const { return below.size() + above.size(); }
    };

    Prospect build(std::size_t node, std::size_t first, const Box& cell, Allowance);
    Prospect make_leaf(std::size_t node, std::size_t first, const Box& cell);
    std::size_t divide(std::size_t first, const std::pair<Box, Box>& cells, const Split&);
    Sides sides(const Fragment&, const std::pair<Box, Box>& cells, const Split&) const;
    Halves take_halves(const std::pair<Box, Box>& cells, const Split&);
    std::pair<Prospect, Prospect> fork(std::uint32_t children, Halves,
                                       const std::pair<Box, Box>& cells, Allowance);
    void adopt(std::size_t node, const Subtree&);

    const Task& task_;
    std::vector<Fragment> fragments_;
    std::vector<KdNode> nodes_;
    std::vector<std::uint32_t> items_;
    SplitFinder finder_;
    Prospect prospect_;
};

std::pair<Box, Box> halves(const Box& cell, const Split& split) {
    std::pair<Box, Box> result{cell, cell};
    result.first.high[split.axis] = split.position;
    result.second.low[split.axis] = split.position;
    return result;
}

/// Builds the cell whose fragments are those from `first` on, and takes them off the stack.
Prospect Subtree::build(std::size_t node, std::size_t first, const Box& cell, Allowance allowance) {
    const std::size_t count = fragments_.size() - first;
    const auto leaf_size = static_cast<std::size_t>(std::max(task_.settings.leaf_size, 0));
    if (count <= leaf_size || allowance.depth == 0 || allowance.duplication < 1)
        return make_leaf(node, first, cell);
    const Split split = finder_.find(std::span(fragments_).subspan(first), cell);
    if (!split.found()) return make_leaf(node, first, cell);

    const auto cells = halves(cell, split);
    const bool forks = count > fork_limit;
    Halves apart;
    const std::size_t lower_first = forks ? 0 : divide(first, cells, split);
    if (forks) apart = take_halves(cells, split);
    const std::size_t parts = forks ? apart.size() : fragments_.size() - first;
    --allowance.depth;
    allowance.duplication *= static_cast<double>(count) / static_cast<double>(parts);
    const auto children = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node] = KdNode::inner(split.axis, split.position, children);
    nodes_.insert(nodes_.end(), 2, KdNode::leaf(0, 0));
    std::pair<Prospect, Prospect> found;
    if (forks) {
        found = fork(children, std::move(apart), cells, allowance);
    } else {
        found.first = build(children, lower_first, cells.first, allowance);
        found.second = build(children + 1, first, cells.second, allowance);
    }
    const Order order(cell, cells, found.first, found.second);
    nodes_[node] = nodes_[node].with_likely(order.likely);
    return order.whole;
}

Prospect Subtree::make_leaf(std::size_t node, std::size_t first, const Box& cell) {
    const Prospect found = ::prospect(std::span(fragments_).subspan(first), cell);
    nodes_[node] = KdNode::leaf(static_cast<std::uint32_t>(items_.size()),
                                static_cast<std::uint32_t>(fragments_.size() - first));
    for (std::size_t i = first; i < fragments_.size(); ++i) items_.push_back(fragments_[i].item);
    fragments_.resize(first);
    return found;
}

/// The parts of a fragment on both sides of a plane; empty boxes where there are none. Only boxes
/// that lie on both sides need clipping.
Subtree::Sides Subtree::sides(const Fragment& f, const std::pair<Box, Box>& cells,
                              const Split& split) const {
    const auto clipped = [&](const Box& cell) {
        const Box side = grown(cell, task_.slack);
        const Box box = clip(f.box, side);
        if (box.empty() || !task_.clip_item) return box;
        return clip(box, task_.clip_item(f.item, side));
    };
    const bool is_below = reaches_below(f.box.low[split.axis], split.position, task_.slack);
    const bool is_above = reaches_above(f.box.high[split.axis], split.position, task_.slack);
    if (is_below && is_above) return {clipped(cells.first), clipped(cells.second)};
    return {is_below ? f.box : Box(), is_above ? f.box : Box()};
}

/// Replaces the fragments from `first` on by those above the plane, then those below it; returns
/// where these begin. Items keep their order.
std::size_t Subtree::divide(std::size_t first, const std::pair<Box, Box>& cells,
                            const Split& split) {
    const std::size_t end = fragments_.size();
    std::size_t above = first;
    for (std::size_t i = first; i < end; ++i) {
        const Fragment f = fragments_[i];
        const bool is_below = reaches_below(f.box.low[split.axis], split.position, task_.slack);
        const bool is_above = reaches_above(f.box.high[split.axis], split.position, task_.slack);
        if (!is_below) {
            fragments_[above++] = f;
        } else if (!is_above) {
            fragments_.push_back(f);
        } else {
            const Sides part = sides(f, cells, split);
            if (!part.above.empty()) fragments_[above++] = {part.above, f.item};
            if (!part.below.empty()) fragments_.push_back({part.below, f.item});
        }
    }
    fragments_.erase(fragments_.begin() + static_cast<std::ptrdiff_t>(above),
                     fragments_.begin() + static_cast<std::ptrdiff_t>(end));
    return above;
}

/// The same for all fragments of a large cell, which is always the root of its subtree: each half
/// gets the room that it needs and not more, and that of the whole is given back.
Subtree::Halves Subtree::take_halves(const std::pair<Box, Box>& cells, const Split& split) {
    std::size_t below = 0, above = 0;
    for (const Fragment& f : fragments_) {
        below += reaches_below(f.box.low[split.axis], split.position, task_.slack);
        above += reaches_above(f.box.high[split.axis], split.position, task_.slack);
    }
    Halves result;
    result.below.reserve(below);
    result.above.reserve(above);
    // What has been read is given back now and then, so that not all is there twice.
    constexpr std::size_t batch = 1 << 16;
    for (std::size_t i = 0; i < fragments_.size(); ++i) {
        const Fragment& f = fragments_[i];
        const Sides part = sides(f, cells, split);
        if (!part.above.empty()) result.above.push_back({part.above, f.item});
        if (!part.below.empty()) result.below.push_back({part.below, f.item});
        if ((i + 1) % batch == 0)
            give_back_pages(&fragments_[i + 1 - batch], batch * sizeof(Fragment));
    }
    std::vector<Fragment>().swap(fragments_);
    return result;
}

/// Builds the halves side by side, with the same result as one after the other: each apart, then
/// appended in order.
std::pair<Prospect, Prospect> Subtree::fork(std::uint32_t children, Halves halves,
                                            const std::pair<Box, Box>& cells, Allowance allowance) {
    std::optional<Subtree> lower;
    std::optional<Subtree> upper;
    run_both(
        task_.threads,
        [&] { lower.emplace(task_, std::move(halves.below), cells.first, allowance); },
        [&] { upper.emplace(task_, std::move(halves.above), cells.second, allowance); });
    const std::pair found{lower->prospect(), upper->prospect()};
    adopt(children, *lower);
    lower.reset();
    adopt(children + 1, *upper);
    return found;
}

void Subtree::adopt(std::size_t node, const Subtree& other) {
    const auto node_offset = static_cast<std::uint32_t>(nodes_.size() - 1);
    const auto item_offset = static_cast<std::uint32_t>(items_.size());
    nodes_[node] = other.nodes_[0].moved(node_offset, item_offset);
    for (std::size_t i = 1; i < other.nodes_.size(); ++i) {
        nodes_.push_back(other.nodes_[i].moved(node_offset, item_offset));
    }
    items_.insert(items_.end(), other.items_.begin(), other.items_.end());
}

int depth_for(std::size_t items, const KdTreeSettings& settings) {
    const int automatic = static_cast<int>(8 + 1.3 * std::log2(static_cast<double>(items)));
    return std::clamp(settings.max_depth > 0 ? settings.max_depth : automatic, 0,
                      KdTree::depth_limit);
}

}  // namespace

KdTree::KdTree(const Box& bounds, std::vector<KdNode> nodes, std::vector<std::uint32_t> items,
               const KdTreeSettings& settings)
    : bounds_(bounds), nodes_(std::move(nodes)), items_(std::move(items)), settings_(settings) {
    nodes_.shrink_to_fit();
    items_.shrink_to_fit();
}

std::size_t KdTree::memory_bytes() const {
    return sizeof(*this) + nodes_.capacity() * sizeof(KdNode) +
           items_.capacity() * sizeof(std::uint32_t) + packs_.size() * sizeof(float);
}

void KdTree::pack(const PackLeaf& pack_leaf) {
    if (nodes_.empty()) return;
    std::size_t packed = 0;
    std::vector<std::pair<std::uint32_t, Box>> todo{{0, bounds_}};
    while (!todo.empty()) {
        const auto [index, cell] = todo.back();
        todo.pop_back();
        KdNode& node = nodes_[index];
        if (node.is_leaf()) {
            node = node.with_pack(packs_.size());
            const auto items = std::span(items_).subspan(node.first_item(), node.item_count());
            if (items.empty()) continue;
            pack_leaf(items, cell, packs_);
            // The first of many leaves tell about how much all of them take: what has its place
            // from the start need not be moved.
            const std::size_t before = std::exchange(packed, packed + items.size());
            if (const std::size_t some = items_.size() / 16; before < some && packed >= some) {
                packs_.reserve(packs_.size() * 17 / packed * items_.size() / 16);
                expect_huge_pages(packs_.data(), packs_.capacity() * sizeof(float));
            }
            continue;
        }
        const auto cells = halves(cell, {static_cast<int>(node.axis()), node.plane(), 0});
        todo.push_back({node.first_child() + 1, cells.second});
        todo.push_back({node.first_child(), cells.first});
    }
    // Those who read packs in lanes may read beyond the last one.
    packs_.resize(packs_.size() + 16);
    if (packs_.capacity() > packs_.size() + packs_.size() / 8) packs_.shrink_to_fit();
    use_huge_pages(nodes_.data(), nodes_.size() * sizeof(KdNode));
    use_huge_pages(packs_.data(), packs_.size() * sizeof(float));
}

KdTree build_kdtree(std::uint32_t items, const ItemBox& box_of, const ClipItem& clip_item,
                    const KdTreeSettings& settings, int threads) {
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
    bounds = grown(bounds, 2 * slack);
    const Allowance allowance{depth_for(fragments.size(), settings), settings.max_duplication};
    const Task task{clip_item, settings, slack, threads};
    std::optional<Subtree> tree;
    run_on_threads(threads, [&] { tree.emplace(task, std::move(fragments), bounds, allowance); });
    if (items > many_items) give_back_freed();
    return KdTree(bounds, tree->take_nodes(), tree->take_items(), settings);
}
