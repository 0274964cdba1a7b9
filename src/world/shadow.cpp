// SPDX-License-Identifier: GPL-3.0-or-later
// The fraction of light that arrives along a straight way.
#include "base/order.h"
#include "base/short_list.h"
#include "base/work_watch.h"
#include "index/asked.h"
#include "shape/leaf_pack.h"
#include "shape/triangle.h"
#include "world/corners.h"
#include "world/item_hits.h"
#include "world/leaf_instances.h"
#include "world/passage.h"
#include "world/prototype.h"
#include "world/world.h"

#include <algorithm>
#include <utility>

namespace candelabra {

namespace {

/// The surfaces of the world, or of an instance, and a ray in their space.
struct RaySpace {
    const Geometry& geometry;
    const Ray& ray;
    PrimitiveIndex first;    ///< the number in the world of the first primitive
    const Transform* place;  ///< to the world; null: it is the world

    Vec3 normal(const Vec3& own) const { return place ? place->normal(own) : own; }
};

/// The transparent surfaces on the way of light, and what they do to it.
class Passages {
public:
    using Solids = std::span<const PrimitiveIndex>;

    Passages(const World& world, const Ray& ray) : world_(world), ray_(ray) {}

    /// Adds the surfaces of an item within the range.
    void collect(std::uint32_t item, const Interval& range);
    /// Sorts the surfaces by distance. This makes the product independent of the tree.
    void sort();
    /// Drops clear surfaces that follow another one, or an end of the way, too closely.
    void keep_apart(double distance, double apart);

    /// Fraction of light that passes all surfaces.
    Rgb passed() const;
    /// The same, asking `use` about those that keep energy.
    Rgb passed(Solids around, const World::UseSurface& use) const;
    /// Attenuation by the interiors of solids along the way.
    Rgb dimmed(Solids around) const;
    /// Passes on the parts of the way between the surfaces.
    void for_stretches(Solids around, double distance, const World::UseStretch& use) const;

private:
    void collect_from(const Instance&, const Interval& range);
    void collect_from(const RaySpace&, std::uint32_t item, const Interval& range);
    Hit hit_at(const Passage&) const;

    const World& world_;
    const Ray& ray_;
    ShortList<Passage, 8> met_;
};

bool may_pass(const World& world, const Geometry& geometry, PrimitiveIndex first,
              std::uint32_t item) {
    if (const Instance* placed = geometry.instance(item))
        return geometry.prototype_of(*placed).clear;
    const PlacedComposite* composite = geometry.composite(item);
    return composite ? composite->transparent : world.material(first + item).transparent;
}

/// Items that were noted, some of them twice.
using NotedItems = ShortList<std::uint32_t, 16>;
void drop_doubles(NotedItems& items) {
    std::ranges::sort(items);
    items.erase(std::unique(items.begin(), items.end()), items.end());
}

void Passages::collect(std::uint32_t item, const Interval& range) {
    if (const Instance* placed = world_.geometry.instance(item))
        collect_from(*placed, range);
    else
        collect_from({world_.geometry, ray_, 0, nullptr}, item, range);
}

void Passages::collect_from(const Instance& placed, const Interval& range) {
    const Geometry& own = world_.geometry.prototype_of(placed).geometry;
    const Ray ray = placed.place->inverse_ray(ray_);
    PackRay packed(ray);
    NotedItems clear;
    own.tree.traverse_likely(ray, range, [&](const TreeLeaf& leaf, const Interval& whole) {
        return packed.candidates(leaf, whole, [&](std::uint32_t item) {
            if (may_pass(world_, own, placed.first, item)) clear.push_back(item);
            return false;
        });
    });
    drop_doubles(clear);
    for (const std::uint32_t item : clear)
        collect_from({own, ray, placed.first, placed.place.get()}, item, range);
}

void Passages::collect_from(const RaySpace& space, std::uint32_t item, const Interval& range) {
    const Geometry& geometry = space.geometry;
    const Ray& ray = space.ray;
    const PrimitiveIndex first = space.first;
    const PrimitiveIndex primitive = first + item;
    if (!geometry.is_composite(item) && world_.material(primitive).no_shadow) return;
    geometry.visit(
        item,
        [&](const SpherePrimitive& s) {
            const double near = first_crossing(s, ray, range);
            if (near >= range.max) return;
            met_.push_back({near, primitive, space.normal(ray.at(near) - s.centre)});
            const double far = first_crossing(s, ray, {near + tolerance_at(ray, near), range.max});
            if (far < range.max)
                met_.push_back({far, primitive, space.normal(ray.at(far) - s.centre)});
        },
        [&](const TrianglePrimitive& face) {
            const TriangleHit hit =
                ShearedRay(ray).meet(face.corner1, face.corner2, face.corner3, range);
            if (hit.t >= range.max || begins_on(ray, hit.t, face)) return;
            met_.push_back(
                {hit.t, primitive,
                 space.normal(cross(face.corner1 - face.corner2, face.corner3 - face.corner2))});
        },
        [&](const PlacedShape& placed) {
            Crossings all;
            all_crossings_in(placed.shape, in_shape(placed, ray), range, all);
            for (std::size_t i = 0; i < all.size(); ++i) {
                if (!range.contains(all[i].t)) continue;
                const Crossing met = in_world(placed, all[i]);
                if (begins_on(ray, met.t, met.normal, size_of(placed, ray))) continue;
                met_.push_back({met.t, primitive, space.normal(met.normal), met.part});
            }
        },
        [&](const PlacedComposite& placed) {
            const PrimitiveIndex leaves = first + placed.first_leaf;
            const auto passed = [&](std::uint32_t leaf) {
                const Material& m = world_.material(leaves + leaf);
                return m.transparent && !m.no_shadow;
            };
            placed.composite->all(ray, range, passed, [&](const Composite::Meeting& each) {
                met_.push_back({each.t, leaves + each.leaf, space.normal(each.normal), each.part});
            });
        });
}

void Passages::sort() {
    sort_stably(met_, {}, [](const Passage& p) { return std::pair(p.t, p.primitive); });
}

void Passages::keep_apart(double distance, double apart) {
    ShortList<Passage, 8> kept;
    double before = 0;
    for (const Passage& each : met_) {
        const bool close = each.t - before <= apart || distance - each.t <= apart;
        if (close && candelabra::passed(world_, each, ray_) != Rgb(0)) continue;
        before = each.t;
        kept.push_back(each);
    }
    met_ = kept;
}

Rgb Passages::passed() const {
    Rgb left(1);
    for (const Passage& each : met_) left *= candelabra::passed(world_, each, ray_);
    return left;
}

EnteredSolids entered(std::span<const PrimitiveIndex> solids) {
    EnteredSolids inside;
    for (const PrimitiveIndex each : solids) inside.push_back(each);
    return inside;
}

Rgb Passages::passed(Solids around, const World::UseSurface& use) const {
    EnteredSolids inside = entered(around);
    Rgb left(1);
    for (const Passage& each : met_) {
        left *= world_.material(each.primitive).keeps_energy
                    ? use(hit_at(each), {inside.data(), inside.size()})
                    : candelabra::passed(world_, each, ray_);
        world_.pass(each.primitive, inside);
    }
    return left;
}

// As in POV-Ray, light that leaves a solid is attenuated by the distance since the last surface,
// whichever that is.
Rgb Passages::dimmed(Solids around) const {
    const bool fades = std::ranges::any_of(met_, [&](const Passage& each) {
        const auto& interior = world_.material(each.primitive).interior;
        return interior && interior->fade_distance != 0 && interior->fade_power > 0;
    });
    if (!fades) return Rgb(1);
    EnteredSolids inside = entered(around);
    Rgb left(1);
    double before = 0;
    for (const Passage& each : met_) {
        const auto& interior = world_.material(each.primitive).interior;
        const bool leaves = world_.pass(each.primitive, inside) != Passing::enters;
        if (leaves && interior && interior->fade_power > 0)
            left *= attenuation(*interior, each.t - before);
        before = each.t;
    }
    return left;
}

Hit Passages::hit_at(const Passage& passage) const {
    Hit hit{passage.primitive, passage.part, ray_.at(passage.t), unit(passage.normal)};
    hit.tolerance = tolerance_at(ray_, passage.t);
    hit.smooth_normal = hit.normal;
    const Geometry* geometry = &world_.geometry;
    PrimitiveIndex primitive = passage.primitive;
    const Transform* place = nullptr;
    if (geometry->is_instanced(primitive)) {
        const Instance& placed = geometry->instance_of(primitive);
        geometry = &geometry->prototype_of(placed).geometry;
        primitive -= placed.first;
        place = placed.place.get();
    }
    if (!geometry->is_triangle(primitive)) return hit;
    const CornerNormals* smooth = geometry->normals_of_triangle(primitive);
    if (!smooth) return hit;
    const TrianglePrimitive& face = geometry->triangle(primitive);
    const Vec3 w = corner_weights({face.corner1, face.corner2, face.corner3},
                                  place ? place->inverse_point(hit.position) : hit.position);
    const Vec3 normal = w.x * smooth->normal1 + w.y * smooth->normal2 + w.z * smooth->normal3;
    hit.smooth_normal = unit(place ? place->normal(normal) : normal);
    return hit;
}

void Passages::for_stretches(Solids around, double distance, const World::UseStretch& use) const {
    EnteredSolids inside;
    for (const PrimitiveIndex each : around)
        if (!world_.material(each).no_shadow) inside.push_back(each);
    double before = 0;
    for (const Passage& each : met_) {
        use(Interval{before, each.t}, {inside.data(), inside.size()});
        before = each.t;
        world_.pass(each.primitive, inside);
    }
    use(Interval{before, distance}, {inside.data(), inside.size()});
}

/// Whether a surface of the instance is in between that stops light.
bool opaque_between(const World& world, const Instance& placed, const Ray& ray,
                    const Interval& range) {
    const Prototype& prototype = world.geometry.prototype_of(placed);
    const Geometry& geometry = prototype.geometry;
    const Ray own = placed.place->inverse_ray(ray);
    RayConstants constants(own);
    PackRay packed(own);
    Asked asked;
    const auto blocks = [&](std::uint32_t item) {
        if (item >= geometry.shapes_begin() && asked.before(item)) return false;
        MetSurface nearest{range.max};
        meet_item(geometry, item, constants, range, nearest, [&](PrimitiveIndex primitive) {
            return prototype.blocks_light ||
                   world.appearance.materials[prototype.material_of[primitive]].stops_light();
        });
        return nearest.primitive != no_primitive;
    };
    return geometry.tree.traverse_likely(
        own, range, [&](const TreeLeaf& leaf, const Interval& whole) {
            return prototype.blocks_light ? packed.blocked(leaf, whole, blocks)
                                          : packed.candidates(leaf, whole, blocks);
        });
}

bool opaque_between(const World& world, std::uint32_t item, RayConstants& constants,
                    const Interval& range) {
    if (const Instance* placed = world.geometry.instance(item))
        return opaque_between(world, *placed, constants.ray(), range);
    MetSurface nearest{range.max};
    meet_item(world.geometry, item, constants, range, nearest,
              [&](PrimitiveIndex primitive) { return world.material(primitive).stops_light(); });
    return nearest.primitive != no_primitive;
}

}  // namespace

Rgb World::transmittance(const Ray& ray, double tolerance, double distance,
                         std::span<const PrimitiveIndex> around, double apart) const {
    return transmittance(ray, tolerance, distance, Shade{around, apart});
}

Rgb World::transmittance(const Ray& ray, double tolerance, double distance,
                         const Shade& shade) const {
    count_work(work_of_ray);
    // The far end lies on the luminaire itself, whose own surface must not count.
    const Interval range{tolerance, end_of_way(tolerance, distance).min};
    RayConstants constants(ray);
    NotedItems clear;
    const auto blocks = [&](std::uint32_t item) {
        if (appearance.any_transparent && may_pass(*this, geometry, 0, item)) clear.push_back(item);
        return opaque_between(*this, item, constants, range);
    };
    for (const InfinitePlane& plane : geometry.infinite.planes) {
        if (!range.contains(plane.intersect(ray))) continue;
        if (material(plane.primitive).stops_light()) return Rgb(0);
        clear.push_back(plane.primitive);
    }
    if (std::ranges::any_of(geometry.infinite.others, blocks)) return Rgb(0);
    PackRay packed(ray);
    Asked asked;
    LeafInstances instances(geometry);
    const auto blocks_in_tree = [&](std::uint32_t item) {
        const bool again = item >= geometry.shapes_begin() && asked.before(item);
        return !again && !instances.take(item) && blocks(item);
    };
    const bool blocked =
        geometry.tree.traverse_likely(ray, range, [&](const TreeLeaf& leaf, const Interval& whole) {
            return (appearance.any_clear ? packed.candidates(leaf, whole, blocks_in_tree)
                                         : packed.blocked(leaf, whole, blocks_in_tree)) ||
                   instances.any_of(blocks);
        });
    if (blocked) return Rgb(0);

    // An item may be tested twice, but counts once.
    drop_doubles(clear);
    Passages found(*this, ray);
    for (const std::uint32_t item : clear) found.collect(item, range);
    found.sort();
    const Passages all = shade.stretches ? found : Passages(*this, ray);
    if (shade.apart > 0) found.keep_apart(distance, shade.apart);
    Rgb left = shade.surfaces ? found.passed(shade.around, *shade.surfaces) : found.passed();
    left *= found.dimmed(shade.around);
    if (shade.stretches && left != Rgb(0))
        all.for_stretches(shade.around, distance, *shade.stretches);
    return left;
}

}  // namespace candelabra
