// SPDX-License-Identifier: GPL-3.0-or-later
// Ray queries of a world.
#include "world/world.h"

#include "base/order.h"
#include "base/work_watch.h"
#include "index/asked.h"
#include "shape/leaf_pack.h"
#include "shape/ray_start.h"
#include "shape/uv.h"
#include "world/corners.h"
#include "world/precedence.h"
#include "world/ray_constants.h"

#include <algorithm>
#include <array>
#include <bit>

namespace candelabra {

namespace {

// Rounding errors of a hit grow with the coordinates and distances from which it is computed. This
// fraction of them is some thousand times the error, and far below anything visible.
constexpr double relative_tolerance = 1e-11;

/// See count_work().
constexpr std::uint32_t work_of_ray = 4;

double tolerance_at(const Ray& ray, double t) {
    return relative_tolerance * (max_abs_component(ray.origin) + t);
}

/// How far along the ray two surfaces in one plane seem to be apart, at most.
double rounding_in(const Ray& ray, double t, const Vec3& normal) {
    constexpr double rounding = 0x1p-48;
    const double size = rounding * (max_abs_component(ray.origin) + t);
    return size * length(normal) / std::abs(dot(ray.direction, normal));
}

/// The next larger number after a positive one.
double next_up(double x) { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + 1); }

/// Crossing in world space, with a normal of any length.
Crossing in_world(const PlacedShape& placed, Crossing crossing) {
    if (placed.transform) crossing.normal = placed.transform->normal(crossing.normal);
    return crossing;
}

Ray in_shape(const PlacedShape& placed, const Ray& ray) {
    return placed.transform ? placed.transform->inverse_ray(ray) : ray;
}

double size_of(const PlacedShape& placed, const Ray& ray) {
    return crossing_size(placed.box, placed.transform.get(), ray.origin);
}

/// First crossing strictly within the range at which the ray does not begin.
std::optional<Crossing> first_crossing(const PlacedShape& placed, const Ray& ray, Interval range) {
    const Ray own = in_shape(placed, ray);
    for (;;) {
        Crossings found;
        crossings_in(placed.shape, own, range, found);
        const Crossing* first = nullptr;
        double nearest = range.max;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const double t = found[i].t;
            if (t <= range.min || t >= nearest) continue;
            nearest = t;
            first = &found[i];
        }
        if (!first) return std::nullopt;
        const Crossing met = in_world(placed, *first);
        if (!begins_on(ray, met.t, met.normal, size_of(placed, ray))) return met;
        range.min = met.t;
    }
}

/// The same for a sphere; range.max if there is none.
double first_crossing(const SpherePrimitive& s, const Ray& ray, const Interval& range) {
    const double t = first_crossing(s.centre, s.radius, ray, range);
    const double size = s.radius + max_abs_component(s.centre);
    if (t >= range.max || !begins_on(ray, t, ray.at(t) - s.centre, size)) return t;
    const double other = first_crossing(s.centre, s.radius, ray, {t, range.max});
    const bool begins = other < range.max && begins_on(ray, other, ray.at(other) - s.centre, size);
    return begins ? range.max : other;
}

bool begins_on(const Ray& ray, double t, const TrianglePrimitive& face) {
    const Vec3 normal = cross(face.corner1 - face.corner2, face.corner3 - face.corner2);
    const double size =
        std::fmax(max_abs_component(face.corner1),
                  std::fmax(max_abs_component(face.corner2), max_abs_component(face.corner3)));
    return begins_on(ray, t, normal, size);
}

/// The outer normal of the flat face that a crossing of a smooth shape belongs to; 0 for crossings
/// that have the normal of the surface itself.
struct FaceNormal {
    std::uint32_t part;

    template <class T>
    Vec3 operator()(const T&) const {
        return Vec3(0);
    }
    Vec3 operator()(const SmoothTriangle& t) const {
        return outer_normal({t.corner1, t.corner2, t.corner3},
                            {unit(t.normal1), unit(t.normal2), unit(t.normal3)});
    }
    Vec3 operator()(const BuiltMesh& built) const {
        const MeshTriangle met = face(*built.mesh, part);
        return outer_normal(met.corners, met.normals);
    }
    Vec3 operator()(const BuiltBicubicPatch& patch) const {
        return outer_normal(patch.facets[part].corners, patch.facets[part].normals);
    }
};

}  // namespace

template <class Wanted>
void World::intersect(std::uint32_t item, RayConstants& constants, const Interval& range,
                      Candidate& best, Wanted wanted) const {
    const Ray& ray = constants.ray();
    geometry.visit(
        item,
        [&](const SpherePrimitive& s) {
            if (!wanted(item)) return;
            const double t = first_crossing(s, ray, {range.min, best.t});
            if (t < best.t) best = {t, item};
        },
        [&](const TrianglePrimitive& face) {
            if (!wanted(item)) return;
            const TriangleHit hit = constants.sheared().meet(face.corner1, face.corner2,
                                                             face.corner3, {range.min, best.t});
            if (hit.t < best.t && !begins_on(ray, hit.t, face))
                best = {hit.t, item, Vec3(0), 0, hit.weight2, hit.weight3};
        },
        [&](const PlacedShape& placed) {
            if (!wanted(item) || constants.slabs().miss(placed.box, {range.min, best.t})) return;
            const auto met = first_crossing(placed, ray, {range.min, best.t});
            if (met) best = {met->t, item, met->normal, met->part};
        },
        [&](const PlacedComposite& placed) {
            const auto own = [&](std::uint32_t leaf) { return wanted(placed.first_leaf + leaf); };
            const auto met = placed.composite->first(ray, {range.min, best.t}, own);
            if (met) best = {met->t, placed.first_leaf + met->leaf, met->normal, met->part};
        });
}

bool World::left_out(PrimitiveIndex primitive, RayKind kind) const {
    const Material& m = material(primitive);
    if (kind == RayKind::light) return false;
    if (kind == RayKind::gathering) return m.no_radiosity;
    return kind == RayKind::camera ? m.no_image : m.no_reflection;
}

Hit World::complete(const Ray& ray, const Candidate& found) const {
    Hit hit;
    hit.primitive = found.primitive;
    hit.part = found.part;
    hit.position = ray.at(found.t);
    hit.tolerance = tolerance_at(ray, found.t);
    const CornerNormals* smooth = nullptr;
    const Vec3 shown = unit(found.normal);
    const auto real = [&](const BuiltShape& shape, const Handle<Transform>& place, bool turned) {
        const Vec3 face = visit_shape(FaceNormal{found.part}, shape);
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

bool World::first_hit(const Ray& ray, double tolerance, RayKind kind, Hit& hit) const {
    count_work(work_of_ray);
    RayConstants constants(ray);
    Candidate best{std::numeric_limits<double>::infinity()};
    const Interval range{tolerance, best.t};
    const auto there = [&](PrimitiveIndex primitive) {
        return !appearance.any_left_out || !left_out(primitive, kind);
    };
    const std::uint32_t first_shape = geometry.shapes_begin();
    std::uint32_t met = 0;  // the item of `best`
    // One of several coincident surfaces counts, in any order of tests: an infinite one, also where
    // rounding puts a finite one in front of it; of two
    // spheres or triangles, as are frequent in meshes, the one with the lower number; else see
    // precedence.h.
    bool finite = false;
    const auto ask = [&](std::uint32_t item) {
        const Candidate before = best;
        const bool by_boxes = finite && (item >= first_shape || met >= first_shape);
        if (item < met || by_boxes) best.t = next_up(best.t);
        intersect(item, constants, range, best, there);
        if (best.primitive == before.primitive)
            best.t = before.t;
        else if (by_boxes && best.t == before.t && !precedes(geometry, item, met, ray))
            best = before;
        else
            met = item;
    };
    for (const InfinitePlane& plane : geometry.infinite.planes) {
        const double t = plane.intersect(ray);
        if (!(t > tolerance && t <= best.t) || !there(plane.primitive)) continue;
        if (t == best.t && met < plane.primitive) continue;
        best = {t, plane.primitive, plane.normal};
        met = plane.primitive;
    }
    for (const std::uint32_t item : geometry.infinite.others) ask(item);
    const Candidate infinite = best;
    if (best.primitive != no_primitive) best.t -= rounding_in(ray, best.t, best.normal);
    met = 0;
    Asked asked;
    const auto ask_in_tree = [&](std::uint32_t item) {
        if (item >= first_shape && asked.before(item)) return false;
        const double before = best.t;
        ask(item);
        finite = finite || best.t < before;
        return false;
    };
    PackRay packed(ray);
    geometry.tree.traverse(ray, {tolerance, best.t}, [&](const TreeLeaf& leaf, Interval& left) {
        packed.candidates(leaf, left, ask_in_tree);
        left.max = best.t;
        return false;
    });
    if (best.primitive == no_primitive) return false;
    if (best.primitive == infinite.primitive) best.t = infinite.t;
    hit = complete(ray, best);
    return true;
}

void World::collect(std::uint32_t item, const Ray& ray, const Interval& range,
                    Passages& found) const {
    if (!geometry.is_composite(item) && material(item).no_shadow) return;
    geometry.visit(
        item,
        [&](const SpherePrimitive& s) {
            const double near = first_crossing(s, ray, range);
            if (near >= range.max) return;
            found.push_back({near, item, ray.at(near) - s.centre});
            const double far = first_crossing(s, ray, {near + tolerance_at(ray, near), range.max});
            if (far < range.max) found.push_back({far, item, ray.at(far) - s.centre});
        },
        [&](const TrianglePrimitive& face) {
            const TriangleHit hit =
                ShearedRay(ray).meet(face.corner1, face.corner2, face.corner3, range);
            if (hit.t >= range.max || begins_on(ray, hit.t, face)) return;
            found.push_back(
                {hit.t, item, cross(face.corner1 - face.corner2, face.corner3 - face.corner2)});
        },
        [&](const PlacedShape& placed) {
            Crossings all;
            all_crossings_in(placed.shape, in_shape(placed, ray), range, all);
            for (std::size_t i = 0; i < all.size(); ++i) {
                if (!range.contains(all[i].t)) continue;
                const Crossing met = in_world(placed, all[i]);
                if (begins_on(ray, met.t, met.normal, size_of(placed, ray))) continue;
                found.push_back({met.t, item, met.normal, met.part});
            }
        },
        [&](const PlacedComposite& placed) {
            const auto passed = [&](std::uint32_t leaf) {
                const Material& m = material(placed.first_leaf + leaf);
                return m.transparent && !m.no_shadow;
            };
            placed.composite->all(ray, range, passed, [&](const Composite::Meeting& each) {
                found.push_back({each.t, placed.first_leaf + each.leaf, each.normal, each.part});
            });
        });
}

bool World::opaque_between(std::uint32_t item, RayConstants& constants,
                           const Interval& range) const {
    Candidate nearest{range.max};
    intersect(item, constants, range, nearest,
              [&](PrimitiveIndex primitive) { return material(primitive).stops_light(); });
    return nearest.primitive != no_primitive;
}

bool World::may_pass(std::uint32_t item) const {
    const PlacedComposite* composite = geometry.composite(item);
    return composite ? composite->transparent : material(item).transparent;
}

/// Drops clear surfaces that follow another one, or an end of the way, too closely.
void World::keep_apart(Passages& passages, const Ray& ray, double distance, double apart) const {
    Passages kept;
    double before = 0;
    for (const Passage& each : passages) {
        const bool close = each.t - before <= apart || distance - each.t <= apart;
        if (close && passed(each, ray) != Vec3(0)) continue;
        before = each.t;
        kept.push_back(each);
    }
    passages = kept;
}

/// Attenuation by the interiors of solids along the way. As in POV-Ray, light that leaves a solid
/// is attenuated by the distance since the last surface, whichever that is.
Vec3 World::dimmed(const Passages& passages, std::span<const PrimitiveIndex> solids) const {
    const bool fades = std::ranges::any_of(passages, [&](const Passage& each) {
        const auto& interior = material(each.primitive).interior;
        return interior && interior->fade_distance != 0 && interior->fade_power > 0;
    });
    if (!fades) return Vec3(1);
    EnteredSolids inside;
    for (const PrimitiveIndex each : solids) inside.push_back(each);
    Vec3 left(1);
    double before = 0;
    for (const Passage& each : passages) {
        const auto& interior = material(each.primitive).interior;
        const bool leaves = pass(each.primitive, inside) != Passing::enters;
        if (leaves && interior && interior->fade_power > 0)
            left *= attenuation(*interior, each.t - before);
        before = each.t;
    }
    return left;
}

Hit World::hit_at(const Passage& passage, const Ray& ray) const {
    Hit hit{passage.primitive, passage.part, ray.at(passage.t), unit(passage.normal)};
    hit.tolerance = tolerance_at(ray, passage.t);
    hit.smooth_normal = hit.normal;
    if (!geometry.is_triangle(passage.primitive)) return hit;
    const CornerNormals* smooth = geometry.normals_of_triangle(passage.primitive);
    if (!smooth) return hit;
    const TrianglePrimitive& face = geometry.triangle(passage.primitive);
    const Vec3 w = corner_weights({face.corner1, face.corner2, face.corner3}, hit.position);
    hit.smooth_normal = unit(w.x * smooth->normal1 + w.y * smooth->normal2 + w.z * smooth->normal3);
    return hit;
}

/// Fraction of light that passes all surfaces of its way.
Vec3 World::passed(const Passages& passages, const Ray& ray, std::span<const PrimitiveIndex> around,
                   const UseSurface& use) const {
    EnteredSolids inside;
    for (const PrimitiveIndex each : around) inside.push_back(each);
    Vec3 left(1);
    for (const Passage& each : passages) {
        left *= material(each.primitive).keeps_energy
                    ? use(hit_at(each, ray), {inside.data(), inside.size()})
                    : passed(each, ray);
        pass(each.primitive, inside);
    }
    return left;
}

/// Passes on the parts of a light's way between the surfaces that it passes.
void World::for_stretches(const Passages& passages, std::span<const PrimitiveIndex> around,
                          double distance, const UseStretch& use) const {
    EnteredSolids inside;
    for (const PrimitiveIndex each : around)
        if (!material(each).no_shadow) inside.push_back(each);
    double before = 0;
    for (const Passage& each : passages) {
        use(Interval{before, each.t}, {inside.data(), inside.size()});
        before = each.t;
        pass(each.primitive, inside);
    }
    use(Interval{before, distance}, {inside.data(), inside.size()});
}

Vec3 World::transmittance(const Ray& ray, double tolerance, double distance,
                          std::span<const PrimitiveIndex> around, double apart) const {
    return transmittance(ray, tolerance, distance, Shade{around, apart});
}

Vec3 World::transmittance(const Ray& ray, double tolerance, double distance,
                          const Shade& shade) const {
    count_work(work_of_ray);
    // The far end lies on the luminaire itself, whose own surface must not count.
    const Interval range{tolerance, end_of_way(tolerance, distance).min};
    RayConstants constants(ray);
    ShortList<std::uint32_t, 16> clear;
    const auto blocks = [&](std::uint32_t item) {
        if (appearance.any_transparent && may_pass(item)) clear.push_back(item);
        return opaque_between(item, constants, range);
    };
    for (const InfinitePlane& plane : geometry.infinite.planes) {
        if (!range.contains(plane.intersect(ray))) continue;
        if (material(plane.primitive).stops_light()) return Vec3(0);
        clear.push_back(plane.primitive);
    }
    if (std::ranges::any_of(geometry.infinite.others, blocks)) return Vec3(0);
    PackRay packed(ray);
    Asked asked;
    const auto blocks_in_tree = [&](std::uint32_t item) {
        return !(item >= geometry.shapes_begin() && asked.before(item)) && blocks(item);
    };
    const bool blocked =
        geometry.tree.traverse_likely(ray, range, [&](const TreeLeaf& leaf, const Interval& whole) {
            return appearance.any_clear ? packed.candidates(leaf, whole, blocks_in_tree)
                                        : packed.blocked(leaf, whole, blocks_in_tree);
        });
    if (blocked) return Vec3(0);

    // An item may be tested twice, but counts once. Sorting makes the product independent of the
    // tree.
    std::ranges::sort(clear);
    clear.erase(std::unique(clear.begin(), clear.end()), clear.end());
    Vec3 left(1);
    Passages found;
    for (const std::uint32_t item : clear) collect(item, ray, range, found);
    sort_stably(found, {}, [](const Passage& p) { return std::pair(p.t, p.primitive); });
    const Passages all = shade.stretches ? found : Passages();
    if (shade.apart > 0) keep_apart(found, ray, distance, shade.apart);
    if (shade.surfaces)
        left = passed(found, ray, shade.around, *shade.surfaces);
    else
        for (const Passage& each : found) left *= passed(each, ray);
    left *= dimmed(found, shade.around);
    if (shade.stretches && left != Vec3(0))
        for_stretches(all, shade.around, distance, *shade.stretches);
    return left;
}

bool World::contains_point(PrimitiveIndex primitive, const Vec3& point) const {
    return geometry.visit(
        geometry.item_of(primitive),
        [&](const SpherePrimitive& s) { return length(point - s.centre) < s.radius; },
        [](const TrianglePrimitive&) { return false; },
        [&](const PlacedShape& placed) {
            return inside(placed.shape,
                          placed.transform ? placed.transform->inverse_point(point) : point);
        },
        [&](const PlacedComposite& placed) { return placed.composite->inside(point); });
}

bool World::is_noted_solid(std::uint32_t item) const {
    if (geometry.is_triangle(item)) return false;
    const PlacedComposite* placed = geometry.composite(item);
    const Material& outer = material(placed ? placed->first_leaf : item);
    // An opaque solid may contain the camera, or have holes through which its inside is seen.
    return ((has_air() || has_media()) && !outer.hollow) || outer.interior ||
           (placed ? placed->transparent : outer.transparent);
}

void World::add_if_inside(std::uint32_t item, const Vec3& point, EnteredSolids& found) const {
    if (!contains(geometry.noticed_in(item), point)) return;
    const PlacedComposite* placed = geometry.composite(item);
    if (!placed) {
        if (contains_point(item, point)) found.push_back(item);
        return;
    }
    if (!placed->composite->inside(point)) return;
    // The solid's interior is the one behind its first transparent leaf.
    PrimitiveIndex leaf = placed->first_leaf;
    while (placed->transparent && !material(leaf).transparent) ++leaf;
    found.push_back(leaf);
}

EnteredSolids World::containing(const Vec3& point) const {
    EnteredSolids found;
    if (!notes_solids()) return found;
    if (indexes_solids()) {
        for (const std::uint32_t item : geometry.clear_solids.infinite)
            add_if_inside(item, point, found);
        geometry.clear_solids.index.around(point, [&](std::uint32_t part) {
            add_if_inside(geometry.clear_solids.finite[part], point, found);
        });
        return found;
    }
    for (std::uint32_t item = 0; item < geometry.item_count(); ++item)
        if (is_noted_solid(item)) add_if_inside(item, point, found);
    return found;
}

Passing World::pass(PrimitiveIndex primitive, EnteredSolids& inside) const {
    const auto at = std::ranges::find(inside, solid(primitive),
                                      [&](PrimitiveIndex each) { return solid(each); });
    if (at == inside.end()) {
        inside.push_back(primitive);
        return Passing::enters;
    }
    const bool innermost = at + 1 == inside.end();
    inside.erase(at);
    return innermost ? Passing::leaves_innermost : Passing::leaves_outer;
}

Vec3 World::emission(PrimitiveIndex primitive, const Vec3& point, Side side) const {
    const PatternScene scene = pattern_scene(primitive, any_part, point);
    Vec3 sum(0);
    for_textures(primitive, any_part, point, side, [&](double weight, const Texture& texture) {
        sum += weight * candelabra::emission(texture, point, scene,
                                             [&](const Colour& colour) { return opacity(colour); });
    });
    return sum;
}

bool World::reaches(std::uint32_t light_group, const Material& lit) const {
    if (light_group == 0) return lights.groups[lit.light_group].global_lights;
    return light_group == lit.light_group || light_group == lights.groups[lit.light_group].outer;
}

bool World::light_is_drawn() const {
    return !lights.luminaires.empty() ||
           std::ranges::any_of(lights.source_sets,
                               [](const SourceSet& set) { return set.drawn(); });
}

Vec3 World::sky_radiance(const Vec3& direction, const Vec3& behind) const {
    if (!sky.sphere) return behind;
    return radiance(*sky.sphere, direction, behind, pattern_scene(), rules.language_version < 3.7);
}

double World::sky_clear(const Vec3& direction) const {
    if (rules.language_version < 3.7) return 1;
    const double clear = std::clamp(grey(sky.background.colour.passing()), 0.0, 1.0);
    if (!sky.sphere) return clear;
    const auto seen = [&](const Vec3& behind) {
        return radiance(*sky.sphere, direction, behind, pattern_scene(), false);
    };
    return std::min(1.0, clear * std::abs(grey(seen(Vec3(1)) - seen(Vec3(0)))));
}

double World::opacity(const Colour& colour) const {
    // Before version 3.7, filter counted by the brightest channel of the colour.
    if (rules.language_version < 3.7)
        return 1 - colour.filter * max_component(colour.rgb) - colour.transmit;
    return colour.opacity();
}

}  // namespace candelabra
