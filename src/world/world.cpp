// SPDX-License-Identifier: GPL-3.0-or-later
// The questions that rays ask of a world.
#include "world/world.h"

#include "index/asked.h"
#include "shape/leaf_pack.h"
#include "shape/uv.h"
#include "world/precedence.h"
#include "world/ready_ray.h"

#include <algorithm>
#include <array>
#include <bit>

namespace {

// Rounding errors of a hit grow with the coordinates and distances that it is computed from; this
// share of them is some thousand times the error and far below anything that is seen.
constexpr double relative_tolerance = 1e-11;

double tolerance_at(const Ray& ray, double t) {
    return relative_tolerance * (max_abs_component(ray.origin) + t);
}

/// The next larger number after a positive one.
double next_up(double x) { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + 1); }

}  // namespace

void World::meet_shape(PrimitiveIndex primitive, const Ray& ray, const Interval& range,
                       Candidate& best) const {
    const PlacedShape& placed = geometry.shapes[primitive - geometry.shapes_begin()];
    Crossings found;
    crossings_in(placed.shape, placed.transform ? placed.transform->inverse_ray(ray) : ray,
                 {range.min, best.t}, found);
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double t = found[i].t;
        if (t <= range.min || t >= best.t) continue;
        best = {t, primitive,
                placed.transform ? placed.transform->normal(found[i].normal) : found[i].normal,
                found[i].part};
    }
}

/// The leaves for which wanted(PrimitiveIndex) is true.
template <class Wanted>
void World::meet_composite(std::uint32_t index, const Ray& ray, const Interval& range,
                           Candidate& best, Wanted wanted) const {
    const PlacedComposite& placed = geometry.composites[index];
    const auto own = [&](std::uint32_t leaf) { return wanted(placed.first_leaf + leaf); };
    const auto met = placed.composite->first(ray, {range.min, best.t}, own);
    if (met) best = {met->t, placed.first_leaf + met->leaf, met->normal, met->part};
}

void World::meet(PrimitiveIndex primitive, ReadyRay& ready, const Interval& range,
                 Candidate& best) const {
    const Ray& ray = ready.ray();
    if (primitive < geometry.spheres.size()) {
        const SpherePrimitive& s = geometry.spheres[primitive];
        const double t = first_crossing(s.centre, s.radius, ray, {range.min, best.t});
        if (t < best.t) best = {t, primitive};
    } else if (primitive < geometry.shapes_begin()) {
        const TrianglePrimitive& face = geometry.triangles[primitive - geometry.spheres.size()];
        const TriangleHit hit =
            ready.sheared().meet(face.corner1, face.corner2, face.corner3, {range.min, best.t});
        if (hit.t < best.t) best = {hit.t, primitive, Vec3(0), 0, hit.weight2, hit.weight3};
    } else {
        const PlacedShape& placed = geometry.shapes[primitive - geometry.shapes_begin()];
        if (!ready.slabs().miss(placed.box, {range.min, best.t}))
            meet_shape(primitive, ray, range, best);
    }
}

bool World::left_out(PrimitiveIndex primitive, RayKind kind) const {
    const Material& m = material(primitive);
    if (kind == RayKind::light || kind == RayKind::gathering) return false;
    return kind == RayKind::camera ? m.no_image : m.no_reflection;
}

Hit World::complete(const Ray& ray, const Candidate& found) const {
    Hit hit;
    hit.primitive = found.primitive;
    hit.part = found.part;
    hit.position = ray.at(found.t);
    hit.tolerance = tolerance_at(ray, found.t);
    if (found.primitive < geometry.spheres.size()) {
        hit.normal = (hit.position - geometry.spheres[found.primitive].centre) /
                     geometry.spheres[found.primitive].radius;
    } else if (found.primitive < geometry.shapes_begin()) {
        const std::size_t face = found.primitive - geometry.spheres.size();
        const TrianglePrimitive& f = geometry.triangles[face];
        hit.normal = unit(cross(f.corner1 - f.corner2, f.corner3 - f.corner2));
        if (!geometry.normals_of.empty() && geometry.normals_of[face] != no_primitive) {
            const CornerNormals& n = geometry.normals[geometry.normals_of[face]];
            hit.smooth_normal = unit((1 - found.weight2 - found.weight3) * n.normal1 +
                                     found.weight2 * n.normal2 + found.weight3 * n.normal3);
            return hit;
        }
    } else {
        hit.normal = unit(found.normal);
    }
    hit.smooth_normal = hit.normal;
    return hit;
}

bool World::first_hit(const Ray& ray, double tolerance, RayKind kind, Hit& hit) const {
    ReadyRay ready(ray);
    Candidate best{std::numeric_limits<double>::infinity()};
    const Interval range{tolerance, best.t};
    const std::uint32_t first_composite = geometry.leaves_begin();
    const auto there = [&](PrimitiveIndex primitive) {
        return !appearance.any_left_out || !left_out(primitive, kind);
    };
    const auto first_shape = geometry.shapes_begin();
    std::uint32_t met = 0;  // the item of `best`
    // Of surfaces in one place one counts, whatever the order of asking: what has no end; of two
    // spheres or triangles, as meshes are full of, the lower number; else see precedence.h.
    bool finite = false;
    const auto ask = [&](std::uint32_t item) {
        const Candidate before = best;
        const bool by_boxes = finite && (item >= first_shape || met >= first_shape);
        if (item < met || by_boxes) best.t = next_up(best.t);
        if (item >= first_composite)
            meet_composite(item - first_composite, ray, range, best, there);
        else if (there(item))
            meet(item, ready, range, best);
        if (best.primitive == before.primitive)
            best.t = before.t;
        else if (by_boxes && best.t == before.t && !precedes(*this, item, met, ray))
            best = before;
        else
            met = item;
    };
    for (const EndlessPlane& plane : geometry.planes) {
        const double t = plane.meet(ray);
        if (!(t > tolerance && t <= best.t) || !there(plane.primitive)) continue;
        if (t == best.t && met < plane.primitive) continue;
        best = {t, plane.primitive, plane.normal};
        met = plane.primitive;
    }
    for (const std::uint32_t item : geometry.endless) ask(item);
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
    hit = complete(ray, best);
    return true;
}

void World::collect(std::uint32_t item, const Ray& ray, const Interval& range,
                    Passages& found) const {
    if (item >= geometry.leaves_begin()) {
        const PlacedComposite& placed = geometry.composites[item - geometry.leaves_begin()];
        const auto passed = [&](std::uint32_t leaf) {
            const Material& m = material(placed.first_leaf + leaf);
            return m.transparent && !m.no_shadow;
        };
        placed.composite->all(ray, range, passed, [&](const Composite::Meeting& each) {
            found.push_back({each.t, placed.first_leaf + each.leaf, each.normal, each.part});
        });
        return;
    }
    if (material(item).no_shadow) return;
    if (item < geometry.spheres.size()) {
        const SpherePrimitive& s = geometry.spheres[item];
        const double near = first_crossing(s.centre, s.radius, ray, range);
        if (near >= range.max) return;
        found.push_back({near, item, ray.at(near) - s.centre});
        const double far =
            first_crossing(s.centre, s.radius, ray, {near + tolerance_at(ray, near), range.max});
        if (far < range.max) found.push_back({far, item, ray.at(far) - s.centre});
    } else if (item < geometry.shapes_begin()) {
        Candidate best{range.max};
        ReadyRay ready(ray);
        meet(item, ready, range, best);
        const TrianglePrimitive& face = geometry.triangles[item - geometry.spheres.size()];
        if (best.primitive != no_primitive)
            found.push_back(
                {best.t, item, cross(face.corner1 - face.corner2, face.corner3 - face.corner2)});
    } else {
        const PlacedShape& placed = geometry.shapes[item - geometry.shapes_begin()];
        Crossings all;
        all_crossings_in(placed.shape, placed.transform ? placed.transform->inverse_ray(ray) : ray,
                         range, all);
        for (std::size_t i = 0; i < all.size(); ++i)
            if (range.contains(all[i].t))
                found.push_back(
                    {all[i].t, item,
                     placed.transform ? placed.transform->normal(all[i].normal) : all[i].normal,
                     all[i].part});
    }
}

bool World::opaque_between(std::uint32_t item, ReadyRay& ready, const Interval& range) const {
    const auto blocks = [&](PrimitiveIndex primitive) { return material(primitive).stops_light(); };
    Candidate nearest{range.max};
    if (item >= geometry.leaves_begin())
        meet_composite(item - geometry.leaves_begin(), ready.ray(), range, nearest, blocks);
    else if (blocks(item))
        meet(item, ready, range, nearest);
    return nearest.primitive != no_primitive;
}

bool World::may_pass(std::uint32_t item) const {
    return item < geometry.leaves_begin()
               ? material(item).transparent
               : geometry.composites[item - geometry.leaves_begin()].transparent;
}

/// Leaves out what is clear and follows another, or an end of the way, too closely.
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

/// What the insides of solids leave of light that passes through their surfaces. As in POV-Ray,
/// what the light leaves dims it by the way since the last surface, whichever that is.
Vec3 World::dimmed(const Passages& passages, std::span<const PrimitiveIndex> solids) const {
    const bool fades = std::ranges::any_of(passages, [&](const Passage& each) {
        const auto& interior = material(each.primitive).interior;
        return interior && interior->fade_distance != 0 && interior->fade_power > 0;
    });
    if (!fades) return Vec3(1);
    std::vector<std::uint32_t> around;
    for (const PrimitiveIndex each : solids) around.push_back(solid(each));
    const auto left_behind = [&](const Passage& passage) {
        const std::uint32_t passed = solid(passage.primitive);
        if (std::erase(around, passed) != 0) return true;
        around.push_back(passed);
        return false;
    };
    Vec3 left(1);
    double before = 0;
    for (const Passage& each : passages) {
        const auto& interior = material(each.primitive).interior;
        if (left_behind(each) && interior && interior->fade_power > 0)
            left *= attenuation(*interior, each.t - before);
        before = each.t;
    }
    return left;
}

Vec3 World::transmittance(const Ray& ray, double tolerance, double distance,
                          std::span<const PrimitiveIndex> around, double apart) const {
    // The far end lies on the luminaire itself, whose own surface must not count.
    const Interval range{tolerance, distance * (1 - 1e-7) - tolerance};
    ReadyRay ready(ray);
    ShortList<std::uint32_t, 16> clear;
    const auto blocks = [&](std::uint32_t item) {
        if (appearance.any_transparent && may_pass(item)) clear.push_back(item);
        return opaque_between(item, ready, range);
    };
    for (const EndlessPlane& plane : geometry.planes) {
        if (!range.contains(plane.meet(ray))) continue;
        if (material(plane.primitive).stops_light()) return Vec3(0);
        clear.push_back(plane.primitive);
    }
    if (std::ranges::any_of(geometry.endless, blocks)) return Vec3(0);
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

    // An item may be asked twice, and counts once; sorted, so that the product never depends on the
    // tree.
    std::ranges::sort(clear);
    clear.erase(std::unique(clear.begin(), clear.end()), clear.end());
    Vec3 left(1);
    Passages found;
    for (const std::uint32_t item : clear) collect(item, ray, range, found);
    std::ranges::sort(found, {}, [](const Passage& p) { return std::pair(p.t, p.primitive); });
    if (apart > 0) keep_apart(found, ray, distance, apart);
    for (const Passage& each : found) left *= passed(each, ray);
    return left * dimmed(found, around);
}

bool World::contains_point(PrimitiveIndex primitive, const Vec3& point) const {
    if (primitive < geometry.spheres.size())
        return length(point - geometry.spheres[primitive].centre) <
               geometry.spheres[primitive].radius;
    if (primitive < geometry.shapes_begin()) return false;
    if (primitive >= geometry.leaves_begin())
        return geometry.composites[geometry.composite_of[primitive - geometry.leaves_begin()]]
            .composite->inside(point);
    const PlacedShape& placed = geometry.shapes[primitive - geometry.shapes_begin()];
    return inside(placed.shape, placed.transform ? placed.transform->inverse_point(point) : point);
}

bool World::is_noted_solid(std::uint32_t item) const {
    if (item >= geometry.spheres.size() && item < geometry.shapes_begin()) return false;
    const auto* placed = item < geometry.leaves_begin()
                             ? nullptr
                             : &geometry.composites[item - geometry.leaves_begin()];
    const Material& outer = material(placed ? placed->first_leaf : item);
    // What is opaque may be around the camera, or have holes that it is seen through.
    return (has_air() && !outer.hollow) || outer.interior ||
           (placed ? placed->transparent : outer.transparent);
}

void World::add_if_inside(std::uint32_t item, const Vec3& point, EnteredSolids& found) const {
    if (item < geometry.leaves_begin() && contains_point(item, point)) found.push_back(item);
    if (item < geometry.leaves_begin()) return;
    const PlacedComposite& placed = geometry.composites[item - geometry.leaves_begin()];
    if (!contains(placed.around, point) || !placed.composite->inside(point)) return;
    // What is in the solid is what is behind its first transparent leaf.
    PrimitiveIndex leaf = placed.first_leaf;
    while (placed.transparent && !material(leaf).transparent) ++leaf;
    found.push_back(leaf);
}

EnteredSolids World::containing(const Vec3& point) const {
    EnteredSolids found;
    if (view.camera.parallel) {
        for (const std::uint32_t item : geometry.clear_solids.unbounded)
            add_if_inside(item, point, found);
        geometry.clear_solids.index.around(point, [&](std::uint32_t part) {
            add_if_inside(geometry.clear_solids.bounded[part], point, found);
        });
        return found;
    }
    for (std::uint32_t item = 0; item < geometry.leaves_begin() + geometry.composites.size();
         ++item)
        if (is_noted_solid(item)) add_if_inside(item, point, found);
    return found;
}

Vec3 World::emission(PrimitiveIndex primitive, const Vec3& point) const {
    const PatternScene scene = pattern_scene(primitive, any_part, point);
    Vec3 sum(0);
    for_textures(primitive, any_part, point, [&](double weight, const Texture& texture) {
        sum += weight * ::emission(texture, point, scene,
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
