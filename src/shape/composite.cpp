// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/composite.h"

#include "base/infinity.h"
#include "base/long_work.h"
#include "base/short_list.h"
#include "index/asked.h"
#include "index/tree_builder.h"
#include "shape/part_index.h"
#include "shape/ray_start.h"
#include "shape/segment_bound.h"
#include "shape/slabs.h"
#include "shape/transformed.h"

namespace candelabra {

namespace {

/// See count_work(): a leaf that is added, its crossings with a ray, and parts whose boxes a point
/// is compared with.
constexpr std::uint32_t work_of_leaf = 10, work_of_crossing = 4, parts_of_step = 4;

/// Bounds of the part of the leaf in a cell; `own` bounds all of it in its own coordinates.
Box part_in(const CompositeLeaf& leaf, const Box& own, const Box& cell) {
    if (!finite(own)) return cell;
    return clipped_bounds(stick_around(leaf.shape, own, leaf.transform.get()), cell);
}

/// The half space of a leaf that is an untransformed plane, with a unit normal; empty for other
/// leaves.
std::optional<Plane> half_space(const CompositeLeaf& leaf) {
    const Plane* plane = std::get_if<Plane>(&leaf.shape);
    if (!plane || leaf.transform) return std::nullopt;
    const Vec3 normal = unit(plane->normal);
    return leaf.inverse ? Plane{-normal, -plane->distance} : Plane{normal, plane->distance};
}

double size_of(const CompositeLeaf& leaf, const Ray& ray) {
    const Transform* transform = leaf.transform.get();
    const Box own = bounds(leaf.shape);
    return crossing_size(transform ? transform->box(own) : own, transform, ray.origin);
}

double l1_norm(const Vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

Interval common(const Interval& a, const Interval& b) {
    return {std::max(a.min, b.min), std::min(a.max, b.max)};
}

/// The part of the line in the half spaces, slightly enlarged against rounding errors. Half spaces
/// almost parallel to the line are ignored.
Interval within(std::span<const Plane> half_spaces, const Ray& ray) {
    constexpr double slack = 1e-9, min_rise = 1e-5;
    const double size = l1_norm(ray.origin), least = min_rise * l1_norm(ray.direction);
    Interval left{-infinity, infinity};
    for (const Plane& plane : half_spaces) {
        const double rise = dot(ray.direction, plane.normal);
        if (!(std::abs(rise) > least)) continue;
        const double depth = plane.distance - dot(ray.origin, plane.normal) +
                             slack * (size + std::abs(plane.distance));
        const double end = depth / rise;
        if (rise > 0)
            left.max = std::min(left.max, end + slack * std::abs(end));
        else
            left.min = std::max(left.min, end - slack * std::abs(end));
    }
    return left;
}

/// Bounds of the leaf's inside in a box, which may be infinite.
Box within(const CompositeLeaf& leaf, const Box& box) {
    const auto* quadric = std::get_if<Shared<Quadric>>(&leaf.shape);
    if (!quadric || leaf.inverse) return box;
    const Transform* transform = leaf.transform.get();
    if (!transform) return bounds_within(**quadric, box);
    return clip(box, transform->box(bounds_within(**quadric, transform->inverse().box(box))));
}

}  // namespace

// ---- building

PartRef CompositeBuilder::add(CompositeLeaf leaf) {
    count_work(work_of_leaf);
    const Transform* transform = leaf.transform.get();
    const Plane* plane = std::get_if<Plane>(&leaf.shape);
    // A transformed plane may be axis-aligned, and its half space is then bounded on one side.
    if (plane && transform) {
        leaf.shape = transformed(*plane, *transform);
        leaf.transform = nullptr;
        transform = nullptr;
    }
    const Box box = inside_bounds(leaf.shape);
    leaf_regions_.push_back({transform ? transform->box(box) : box, leaf.inverse});
    made_.leaves_.push_back(std::move(leaf));
    return {static_cast<std::uint32_t>(made_.leaves_.size() - 1), true};
}

PartRef CompositeBuilder::add(Combination how, std::vector<PartRef> parts,
                              Handle<Composite> limit) {
    if (parts.size() == 1 && !limit && !parts[0].clips) return parts[0];
    std::vector<PartRef> flat;
    Composite::Region region{how == Combination::common ? everywhere() : Box(), false};
    for (const PartRef& part : parts) {
        const bool same = !part.leaf && !part.clips && how != Combination::merged &&
                          made_.nodes_[part.index].how == how &&
                          made_.nodes_[part.index].limit == Composite::nothing;
        if (same)
            flat.insert(flat.end(), parts_[part.index].begin(), parts_[part.index].end());
        else
            flat.push_back(part);
    }
    count_long_work(1 + flat.size() / parts_of_step);
    // Outside the box, either all parts have their outside values, or the deciding ones do.
    const bool decisive = how != Combination::common;
    Box joined, shared = everywhere();
    bool decided = false;
    for (const PartRef& part : flat) {
        const Composite::Region r = region_of(part);
        joined = join(joined, r.box);
        if (r.outside != decisive) continue;
        shared = clip(shared, r.box);
        decided = true;
    }
    if (decided && !decisive)
        for (const PartRef& part : flat)
            if (part.leaf) shared = within(made_.leaves_[part.index], shared);
    region = {decided ? shared : joined, decided == decisive};
    Composite::Node node;
    node.how = how;
    if (limit) {
        node.limit = static_cast<std::uint32_t>(made_.limits_.size());
        made_.limits_.push_back(std::move(limit));
        made_.limited_ = true;
    }
    made_.nodes_.push_back(std::move(node));
    parts_.push_back(std::move(flat));
    node_regions_.push_back(region);
    return {static_cast<std::uint32_t>(made_.nodes_.size() - 1), false};
}

/// Builds a tree whose items are tested one by one.
WideTree CompositeBuilder::tree_of(std::span<const Box> boxes, const ItemPart& part) const {
    return build_tree(
        static_cast<std::uint32_t>(boxes.size()), [&](std::uint32_t i) { return boxes[i]; }, part,
        tree_settings(index_, 1), boxes.size() > many_parts ? 0 : 1);
}

Composite::Region CompositeBuilder::region_of(const PartRef& part) const {
    return part.leaf ? leaf_regions_[part.index] : node_regions_[part.index];
}

/// Sorts the parts of a node for inside tests.
void CompositeBuilder::settle(std::uint32_t index) {
    Composite::Node& node = made_.nodes_[index];
    const bool decisive = node.how != Combination::common;
    std::vector<Box> boxes;
    bool all_finite = true;
    for (const PartRef& ref : parts_[index]) {
        const Composite::Part part{ref, region_of(ref)};
        if (!decisive && ref.leaf)
            if (const auto half = half_space(made_.leaves_[ref.index])) node.cuts.push_back(*half);
        if (part.region.outside == decisive) {
            node.always.push_back(part);
            continue;
        }
        node.boxed.push_back(part);
        boxes.push_back(part.region.box);
        all_finite = all_finite && (part.region.box.empty() || finite(part.region.box));
    }
    if (node.boxed.size() <= few_parts || !all_finite) return;
    node.index = tree_of(boxes, [&](std::uint32_t i, const Box& cell) {
        const PartRef& ref = node.boxed[i].ref;
        if (!ref.leaf) return cell;
        const CompositeLeaf& leaf = made_.leaves_[ref.index];
        return part_in(leaf, candelabra::inside_bounds(leaf.shape), cell);
    });
}

/// Records the bounds of visible surface, from the root down.
void CompositeBuilder::show(const PartRef& part, const Box& within) {
    if (part.leaf) {
        const CompositeLeaf& leaf = made_.leaves_[part.index];
        const Box box = candelabra::bounds(leaf.shape);
        made_.seen_[part.index] =
            candelabra::within(leaf, clip(leaf.transform ? leaf.transform->box(box) : box, within));
        return;
    }
    Composite::Node& node = made_.nodes_[part.index];
    settle(part.index);
    made_.overlaps_ |= node.how == Combination::together && parts_[part.index].size() > 1;
    Box inner = within;
    if (node.how == Combination::common && !node_regions_[part.index].outside)
        inner = clip(inner, node_regions_[part.index].box);
    if (node.limit != Composite::nothing) inner = clip(inner, made_.limits_[node.limit]->bounds());
    for (const PartRef& child : parts_[part.index]) {
        (child.leaf ? made_.parents_[child.index] : made_.nodes_[child.index].parent) = part.index;
        made_.clipped_ |= child.clips;
        if (!child.clips)
            show(child, inner);
        else if (!child.leaf)
            settle_all(child.index);
    }
}

void CompositeBuilder::settle_all(std::uint32_t index) {
    settle(index);
    for (const PartRef& child : parts_[index])
        if (!child.leaf) settle_all(child.index);
}

Composite CompositeBuilder::finish(PartRef root) {
    made_.parents_.assign(made_.leaves_.size(), Composite::nothing);
    made_.seen_.assign(made_.leaves_.size(), Box());
    made_.root_ = root;
    const Composite::Region region = region_of(root);
    made_.inside_bounds_ = region.outside ? everywhere() : region.box;
    show(root, everywhere());
    for (std::uint32_t node : made_.parents_) {
        std::uint64_t levels = 0;
        for (; node != Composite::nothing && made_.nodes_[node].cuts.empty(); ++levels)
            node = made_.nodes_[node].parent;
        count_long_work(levels / parts_of_step);
        made_.cut_by_.push_back(node);
    }
    std::vector<Box> boxes = made_.seen_;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        if (boxes[i].empty()) continue;
        made_.bounds_ = join(made_.bounds_, boxes[i]);
        if (boxes.size() > few_parts && finite(boxes[i])) continue;
        made_.apart_.push_back(i);
        boxes[i] = Box();
    }
    if (boxes.size() > few_parts)
        made_.tree_ = tree_of(boxes, [&](std::uint32_t i, const Box& cell) {
            const CompositeLeaf& leaf = made_.leaves_[i];
            return part_in(leaf, candelabra::bounds(leaf.shape), cell);
        });
    return std::move(made_);
}

// ---- inside tests

bool Composite::inside_part(const Part& part, const Vec3& point) const {
    if (!contains(part.region.box, point)) return part.region.outside;
    count_work(1);
    if (!part.ref.leaf) return inside_node(nodes_[part.ref.index], point, nullptr);
    const CompositeLeaf& leaf = leaves_[part.ref.index];
    const Plane* plane = std::get_if<Plane>(&leaf.shape);
    if (plane && !leaf.transform) return candelabra::inside(*plane, point) != leaf.inverse;
    return candelabra::inside(leaf.shape, leaf.transform ? leaf.transform->inverse_point(point)
                                                         : point) != leaf.inverse;
}

bool Composite::inside_node(const Node& node, const Vec3& point, const PartRef* aside) const {
    const bool decisive = node.how != Combination::common;
    const bool indexed = !node.index.nodes().empty();
    count_long_work(1 + (node.always.size() + (indexed ? 0 : node.boxed.size())) / parts_of_step);
    const auto decides = [&](const Part& part) {
        const bool left_aside =
            aside && part.ref.leaf == aside->leaf && part.ref.index == aside->index;
        return !left_aside && inside_part(part, point) == decisive;
    };
    for (const Part& part : node.always)
        if (decides(part)) return decisive;
    if (!indexed) {
        for (const Part& part : node.boxed)
            if (contains(part.region.box, point) && decides(part)) return decisive;
        return !decisive;
    }
    // A ray of length 0 visits the leaves around its origin.
    const bool found = node.index.traverse(
        Ray{point, Vec3(1)}, {0, 0}, [&](std::span<const std::uint32_t> items, Interval&) {
            count_long_work(1 + items.size() / parts_of_step);
            return std::ranges::any_of(items, [&](std::uint32_t i) {
                return contains(node.boxed[i].region.box, point) && decides(node.boxed[i]);
            });
        });
    return found ? decisive : !decisive;
}

bool Composite::inside(const Vec3& point) const {
    if (!root_.leaf) return inside_node(nodes_[root_.index], point, nullptr);
    const CompositeLeaf& leaf = leaves_[root_.index];
    return candelabra::inside(leaf.shape, leaf.transform ? leaf.transform->inverse_point(point)
                                                         : point) != leaf.inverse;
}

bool Composite::seen_at(std::uint32_t leaf, const Vec3& point) const {
    PartRef part{leaf, true};
    std::uint64_t levels = 0;
    for (std::uint32_t i = parents_[leaf]; i != nothing; i = nodes_[i].parent) {
        if (++levels % parts_of_step == 0) count_work(1);
        const Node& node = nodes_[i];
        const bool seen = node.how == Combination::common   ? inside_node(node, point, &part)
                          : node.how == Combination::merged ? !inside_node(node, point, &part)
                                                            : true;
        if (!seen) return false;
        part = {i, false};
    }
    return true;
}

// ---- rays

bool Composite::meets(const Ray& ray) const {
    return inside(ray.origin) ||
           first(ray, Interval{}, [](std::uint32_t) { return true; }).has_value();
}

bool Composite::within_limits(std::uint32_t leaf, const Ray& ray) const {
    for (std::uint32_t i = parents_[leaf]; i != nothing; i = nodes_[i].parent)
        if (nodes_[i].limit != nothing && !limits_[nodes_[i].limit]->meets(ray)) return false;
    return true;
}

const Interval& Composite::cut(std::uint32_t leaf, const Ray& ray, Cut& last) const {
    if (cut_by_[leaf] == last.node) return last.left;
    last.node = cut_by_[leaf];
    last.left = last.node == nothing ? Cut().left : candelabra::within(nodes_[last.node].cuts, ray);
    return last.left;
}

/// Finds the points of the leaf's surface in the range; `seen` is the part of the ray that can
/// contain any.
template <class Take>
void Composite::meet_leaf(std::uint32_t index, const Ray& ray, const Interval& range,
                          const Interval& seen, Take take) const {
    count_work(work_of_crossing);
    const CompositeLeaf& leaf = leaves_[index];
    const Transform* transform = leaf.transform.get();
    Crossings found;
    all_crossings_in(leaf.shape, transform ? transform->inverse_ray(ray) : ray, seen, found);
    bool limits_asked = !limited_;
    // Rounding alone decides which of two coincident faces hides the other, and differs from point
    // to point. So points right before and behind are tested as well: a skin stays, as in POV-Ray.
    const auto seen_near = [&](double t) {
        constexpr double rounding = 1e-13;
        const Vec3 point = ray.at(t);
        if (seen_at(index, point)) return true;
        const double size = l1_norm(point) + l1_norm(ray.origin);
        const Vec3 aside = rounding * size / l1_norm(ray.direction) * ray.direction;
        return seen_at(index, point - aside) || seen_at(index, point + aside);
    };
    for (std::size_t i = 0; i < found.size(); ++i) {
        const Crossing& c = found[i];
        if (!range.contains(c.t)) continue;
        if (parents_[index] != nothing && !seen_near(c.t)) continue;
        if (!limits_asked && !within_limits(index, ray)) return;
        limits_asked = true;
        const Vec3 normal = transform ? unit(transform->normal(c.normal)) : c.normal;
        if (begins_on(ray, c.t, normal, size_of(leaf, ray))) continue;
        take(Meeting{c.t, leaf.inverse != leaf.turned ? -normal : normal, index, c.part});
    }
}

std::optional<Composite::Meeting> Composite::first(const Ray& ray, const Interval& range,
                                                   Wanted wanted) const {
    const Slabs slabs(ray);
    // A single leaf has the same bounds.
    if (leaves_.size() > 1 && slabs.miss(bounds_, range)) return std::nullopt;
    std::optional<Meeting> nearest;
    Interval left = range;
    Cut last;
    // Of coincident surfaces, that of the last leaf counts, as in POV-Ray, independent of the order
    // of the tests.
    const auto ask = [&](std::uint32_t leaf) {
        const bool may_share = nearest && leaf > nearest->leaf;
        const Interval there{left.min, may_share ? std::nextafter(left.max, infinity) : left.max};
        const Interval here = common(there, cut(leaf, ray, last));
        if (here.min > here.max) return;
        const Interval seen = slabs.within(seen_[leaf], here);
        if (seen.min > seen.max || !wanted(leaf)) return;
        meet_leaf(leaf, ray, here, seen, [&](const Meeting& met) {
            const bool over = nearest && met.t == nearest->t && met.leaf > nearest->leaf;
            if (nearest && met.t >= nearest->t && !over) return;
            nearest = met;
        });
        if (nearest) left.max = nearest->t;
    };
    for (const std::uint32_t leaf : apart_) ask(leaf);
    Asked asked;
    tree_.traverse(ray, left, [&](std::span<const std::uint32_t> items, Interval& rest) {
        count_long_work(items.size());
        for (const std::uint32_t leaf : items)
            if (!asked.before(leaf)) ask(leaf);
        rest.max = left.max;
        return false;
    });
    return nearest;
}

void Composite::all(const Ray& ray, const Interval& range, Wanted wanted,
                    FunctionRef<void(const Meeting&)> take) const {
    const Slabs slabs(ray);
    ShortList<std::uint32_t, 32> candidates;
    for (const std::uint32_t leaf : apart_)
        if (!slabs.miss(seen_[leaf], range)) candidates.push_back(leaf);
    tree_.traverse(ray, range, [&](std::span<const std::uint32_t> items, Interval&) {
        count_long_work(items.size());
        candidates.insert(candidates.end(), items.begin(), items.end());
        return false;
    });
    std::ranges::sort(candidates);
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    Cut last;
    for (const std::uint32_t leaf : candidates) {
        const Interval here = common(range, cut(leaf, ray, last));
        if (wanted(leaf)) meet_leaf(leaf, ray, here, slabs.within(seen_[leaf], here), take);
    }
}

}  // namespace candelabra
