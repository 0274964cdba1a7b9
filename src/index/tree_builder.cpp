// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/tree_builder.h"

#include "base/long_work.h"
#include "base/memory_pages.h"
#include "base/order.h"
#include "base/parallel.h"
#include "index/node_builder.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace candelabra {

namespace {

/// Number of items from which on a build uses enough memory to be worth giving back.
constexpr std::uint32_t many_items = 16384;
/// Maximum number of items that are cut: pieces of more could exceed the capacity of a hierarchy.
constexpr std::uint32_t max_to_cut = 1u << 23;

}  // namespace

/// Accesses the private parts of the tree.
class TreeBuilder {
public:
    static WideTree make(std::span<PrimRef> fragments, std::vector<std::uint32_t> endless,
                         const Box& bounds, const NodeTask& task) {
        WideTree made;
        made.settings_ = task.costs;
        made.endless_ = std::move(endless);
        if (fragments.empty()) return made;
        made.bounds_ = bounds;
        BuiltNodes built;
        run_on_threads(task.threads, [&] { built = build_nodes(task, fragments, bounds); });
        made.nodes_ = std::move(built.nodes);
        made.nodes_.shrink_to_fit();
        made.frames_ = std::move(built.frames);
        made.leaves_ = std::move(built.leaves);
        choose_foremost(made, fragments, built.prospect.steps);
        return made;
    }

private:
    /// Chooses items that occlude so many rays that testing them first saves more steps than it
    /// costs.
    static void choose_foremost(WideTree& made, std::span<const PrimRef> fragments, double steps) {
        constexpr std::size_t max_leaves = 4;
        // A group among others costs less than a single one.
        constexpr double cost = 0.5;
        const double whole = area(made.bounds_);
        std::vector<const PrimRef*> largest;
        const auto larger = [](const PrimRef* a, const PrimRef* b) {
            return std::pair(area(a->box), b->item) > std::pair(area(b->box), a->item);
        };
        for (const PrimRef& f : fragments)
            if (chance_to_stop(area(f.box), whole) * steps * leaf_limit > cost)
                largest.push_back(&f);
        sort_stably(largest, larger);
        for (std::size_t leaf = 0; leaf < max_leaves && leaf * leaf_limit < largest.size();
             ++leaf) {
            const auto items = std::span(largest).subspan(
                leaf * leaf_limit, std::min(leaf_limit, largest.size() - leaf * leaf_limit));
            double chance = 0;
            for (const PrimRef* f : items) chance += chance_to_stop(area(f->box), whole);
            if (chance * steps < cost) return;
            made.foremost_.push_back(TreeChild::leaf(made.leaves_.size()));
            made.leaves_.push_back(static_cast<std::uint32_t>(items.size()));
            const auto first = static_cast<std::ptrdiff_t>(made.leaves_.size());
            for (const PrimRef* f : items) made.leaves_.push_back(f->item);
            std::sort(made.leaves_.begin() + first, made.leaves_.end());
        }
    }
};

WideTree build_tree(std::uint32_t items, const ItemBox& box_of, const ItemPart& part_of,
                    const TreeSettings& settings, int threads) {
    assert(items < WideTree::item_limit);
    constexpr std::uint64_t work_of_item = 30;
    count_long_work(work_of_item * items);
    std::vector<PrimRef> fragments;
    std::vector<std::uint32_t> endless;
    fragments.reserve(items);
    Box bounds;
    for (std::uint32_t item = 0; item < items; ++item) {
        const Box box = box_of(item);
        if (box.empty()) continue;
        if (!finite(box)) {
            endless.push_back(item);
            continue;
        }
        fragments.push_back({box, item});
        bounds = join(bounds, box);
    }
    double slack = 0;
    if (!fragments.empty())
        slack = 0x1p-46 * std::max(max_abs_component(bounds.low), max_abs_component(bounds.high));
    const auto enlarge = [&](Box& box) { box = {box.low - Vec3(slack), box.high + Vec3(slack)}; };
    for (PrimRef& f : fragments) enlarge(f.box);
    enlarge(bounds);
    const bool cut = settings.by == Division::cells || items <= max_to_cut;
    WideTree made = TreeBuilder::make(fragments, std::move(endless), bounds,
                                      {settings, cut ? part_of : ItemPart(), slack, threads});
    if (items > many_items) give_back_freed();
    return made;
}

}  // namespace candelabra
