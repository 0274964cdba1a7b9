// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest surface on a ray.
#include "base/work_watch.h"
#include "index/asked.h"
#include "shape/face_normal.h"
#include "shape/leaf_pack.h"
#include "world/item_hits.h"
#include "world/leaf_instances.h"
#include "world/precedence.h"
#include "world/prototype.h"
#include "world/world.h"

#include <bit>
#include <limits>

namespace candelabra {

namespace {

/// How far along the ray two surfaces in one plane seem to be apart, at most.
double rounding_in(const Ray& ray, double t, const Vec3& normal) {
    constexpr double rounding = 0x1p-48;
    const double size = rounding * (max_abs_component(ray.origin) + t);
    return size * length(normal) / std::abs(dot(ray.direction, normal));
}

/// The next larger number after a positive one.
double next_up(double x) { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + 1); }

/// Whether a ray of this kind does not see an object.
bool left_out(const Material& m, RayKind kind) {
    if (kind == RayKind::light) return false;
    if (kind == RayKind::gathering) return m.no_radiosity;
    return kind == RayKind::camera ? m.no_image : m.no_reflection;
}

Hit complete(const Geometry& geometry, const Ray& ray, const MetSurface& found) {
    if (geometry.is_instanced(found.primitive)) {
        const Instance& placed = geometry.instance_of(found.primitive);
        MetSurface own = found;
        own.primitive -= placed.first;
        Hit hit =
            complete(geometry.prototype_of(placed).geometry, placed.place->inverse_ray(ray), own);
        hit.primitive = found.primitive;
        hit.position = ray.at(found.t);
        hit.tolerance = tolerance_at(ray, found.t);
        hit.normal = unit(placed.place->normal(hit.normal));
        hit.smooth_normal = unit(placed.place->normal(hit.smooth_normal));
        return hit;
    }
    Hit hit;
    hit.primitive = found.primitive;
    hit.part = found.part;
    hit.position = ray.at(found.t);
    hit.tolerance = tolerance_at(ray, found.t);
    const CornerNormals* smooth = nullptr;
    const Vec3 shown = unit(found.normal);
    const auto real = [&](const BuiltShape& shape, const Handle<Transform>& place, bool turned) {
        const Vec3 face = face_normal(shape, found.part);
        const Vec3 there = unit(place ? place->normal(face) : face);
        return there == Vec3(0) ? shown : turned ? -there : there;
    };
    hit.normal = geometry.visit(
        geometry.item_of(found.primitive),
        [&](const SpherePrimitive& s) { return (hit.position - s.centre) / s.radius; },
        [&](const TrianglePrimitive& f) {
            smooth = geometry.normals_of_triangle(found.primitive);
            return unit(cross(f.corner1 - f.corner2, f.corner3 - f.corner2));
        },
        [&](const PlacedShape& placed) { return real(placed.shape, placed.transform, false); },
        [&](const PlacedComposite& placed) {
            const CompositeLeaf& leaf = placed.composite->leaf(found.primitive - placed.first_leaf);
            return real(leaf.shape, leaf.transform, leaf.inverse != leaf.turned);
        });
    hit.smooth_normal =
        smooth             ? unit((1 - found.weight2 - found.weight3) * smooth->normal1 +
                                  found.weight2 * smooth->normal2 + found.weight3 * smooth->normal3)
        : shown == Vec3(0) ? hit.normal
                           : shown;
    return hit;
}

/// The nearest surface within the range for which wanted(PrimitiveIndex) is true; no_primitive if
/// there is none.
template <class Wanted>
MetSurface nearest(const Geometry& geometry, const Ray& ray, const Interval& range, Wanted wanted) {
    RayConstants constants(ray);
    MetSurface best{range.max};
    const std::uint32_t first_shape = geometry.shapes_begin();
    std::uint32_t met = 0;  // the item of `best`
    // One of several coincident surfaces counts, in any order of tests: an infinite one, also where
    // rounding puts a finite one in front of it; of two
    // spheres or triangles, as are frequent in meshes, the one with the lower number; else see
    // precedence.h.
    bool finite = false;
    const auto ask = [&](std::uint32_t item) {
        const MetSurface before = best;
        const bool by_boxes = finite && (item >= first_shape || met >= first_shape);
        if (item < met || by_boxes) best.t = next_up(best.t);
        meet_item(geometry, item, constants, range, best, wanted);
        if (best.primitive == before.primitive)
            best.t = before.t;
        else if (by_boxes && best.t == before.t && !precedes(geometry, item, met, ray))
            best = before;
        else
            met = item;
    };
    for (const InfinitePlane& plane : geometry.infinite.planes) {
        const double t = plane.intersect(ray);
        if (!(t > range.min && t <= best.t) || !wanted(plane.primitive)) continue;
        if (t == best.t && met < plane.primitive) continue;
        best = {t, plane.primitive, plane.normal};
        met = plane.primitive;
    }
    for (const std::uint32_t item : geometry.infinite.others) ask(item);
    const MetSurface infinite = best;
    if (best.primitive != no_primitive) best.t -= rounding_in(ray, best.t, best.normal);
    met = 0;
    Asked asked;
    LeafInstances instances(geometry);
    const auto ask_and_go_on = [&](std::uint32_t item) {
        const double before = best.t;
        ask(item);
        finite = finite || best.t < before;
        return false;
    };
    const auto ask_in_tree = [&](std::uint32_t item) {
        const bool again = item >= first_shape && asked.before(item);
        return !again && !instances.take(item) && ask_and_go_on(item);
    };
    PackRay packed(ray);
    geometry.tree.traverse(ray, {range.min, best.t}, [&](const TreeLeaf& leaf, Interval& left) {
        packed.candidates(leaf, left, ask_in_tree);
        instances.any_of(ask_and_go_on);
        left.max = best.t;
        return false;
    });
    if (best.primitive == infinite.primitive) best.t = infinite.t;
    return best;
}

}  // namespace

void meet_instance(const Geometry& geometry, const Instance& placed, const Ray& ray,
                   const Interval& range, MetSurface& best,
                   FunctionRef<bool(PrimitiveIndex)> wanted) {
    const Ray own = placed.place->inverse_ray(ray);
    const MetSurface met =
        nearest(geometry.prototype_of(placed).geometry, own, {range.min, best.t},
                [&](PrimitiveIndex primitive) { return wanted(placed.first + primitive); });
    if (met.primitive == no_primitive) return;
    best = met;
    best.primitive += placed.first;
}

bool World::first_hit(const Ray& ray, double tolerance, RayKind kind, Hit& hit) const {
    count_work(work_of_ray);
    const MetSurface met =
        nearest(geometry, ray, {tolerance, std::numeric_limits<double>::infinity()},
                [&](PrimitiveIndex primitive) {
                    return !appearance.any_left_out || !left_out(material(primitive), kind);
                });
    if (met.primitive == no_primitive) return false;
    hit = complete(geometry, ray, met);
    return true;
}

}  // namespace candelabra
