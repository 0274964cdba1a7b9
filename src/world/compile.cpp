// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/compile.h"

#include "index/tree_builder.h"
#include "luminaire/brightness.h"
#include "shape/leaf_pack.h"
#include "shape/moved.h"
#include "shape/stick.h"
#include "solid/assemble.h"
#include "surface/simplified.h"
#include "world/flatten.h"
#include "world/leans.h"
#include "world/precedence.h"

#include <algorithm>

namespace {

std::uint32_t item_count(const World& world) {
    return world.leaves_begin() + static_cast<std::uint32_t>(world.composites.size());
}

/// Empty for what has no end.
Box bounds_in_tree(const World& world, std::uint32_t item) {
    return std::ranges::binary_search(world.unbounded, item) ? Box() : item_bounds(world, item);
}

Box part_in_tree(const World& world, std::uint32_t item, const Box& cell) {
    if (item < world.spheres.size()) {
        const SpherePrimitive& s = world.spheres[item];
        return clipped_bounds(Sphere{s.centre, s.radius}, cell);
    }
    if (item >= world.leaves_begin()) return cell;
    const std::size_t face = item - world.spheres.size();
    if (face < world.triangles.size()) {
        const TrianglePrimitive& t = world.triangles[face];
        return clipped_bounds(Triangle{t.corner1, t.corner2, t.corner3}, cell);
    }
    const PlacedShape& placed = world.shapes[face - world.triangles.size()];
    return clipped_bounds(stick_around(placed.shape, bounds(placed.shape), placed.transform.get()),
                          cell);
}

void build_index(World& world, int threads) {
    world.tree = build_tree(
        item_count(world), [&](std::uint32_t item) { return bounds_in_tree(world, item); },
        [&](std::uint32_t item, const Box& cell) { return part_in_tree(world, item, cell); },
        tree_settings(world.settings.index), threads);
    const auto spheres = static_cast<std::uint32_t>(world.spheres.size());
    const auto faces = static_cast<std::uint32_t>(world.triangles.size());
    const PackedKinds kinds{
        spheres, spheres + faces,
        [&](std::uint32_t item) {
            return PackedKinds::Ball{world.spheres[item].centre, world.spheres[item].radius};
        },
        [&](std::uint32_t item) {
            const TrianglePrimitive& t = world.triangles[item - spheres];
            return std::array{t.corner1, t.corner2, t.corner3};
        },
        [&](std::uint32_t item) { return item_bounds(world, item); }};
    world.tree.pack(leaf_packs(kinds), threads);
}

/// The planes of a scene in world space: where points to be lit may be, besides the bounded
/// primitives.
std::vector<Plane> world_planes(const World& world) {
    std::vector<Plane> planes;
    for (const std::uint32_t primitive : world.unbounded) {
        if (primitive >= world.leaves_begin()) continue;
        const PlacedShape& placed =
            world.shapes[primitive - world.spheres.size() - world.triangles.size()];
        const Plane* plane = std::get_if<Plane>(&placed.shape);
        if (!plane) continue;
        planes.push_back(placed.transform ? moved(*plane, *placed.transform)
                                          : Plane{unit(plane->normal), plane->distance});
    }
    return planes;
}

/// Divides what has no end into planes and others.
void note_planes(World& world) {
    for (const std::uint32_t item : world.unbounded) {
        const std::size_t shape = item - world.spheres.size() - world.triangles.size();
        const Plane* plane = shape < world.shapes.size() && !world.shapes[shape].transform
                                 ? std::get_if<Plane>(&world.shapes[shape].shape)
                                 : nullptr;
        if (!plane) {
            world.endless.push_back(item);
            continue;
        }
        Crossings found;
        crossings(*plane, {Vec3(0), plane->normal}, found);
        world.planes.push_back({found[0].normal, plane->distance, item});
    }
}

/// Lights as they are seen at a quality.
void simplify_lights(World& world) {
    if (world.quality < quality_light) {
        world.lights.clear();
        world.light_reach.clear();
    }
    if (world.quality < quality_shadows)
        for (LightReach& reach : world.light_reach) reach.window = nullptr;
    if (world.quality >= quality_areas) return;
    for (Light& light : world.lights) std::visit([](auto& l) { l.size1 = l.size2 = 0; }, light);
}

World flattened(const Scene& scene, const CompileOptions& options, Flatten what,
                Diagnostics& diagnostics) {
    World world;
    world.quality = options.quality;
    world.settings = scene.settings;
    if (options.index) world.settings.index = *options.index;
    world.language_version = scene.language_version;
    world.camera = projection(scene.camera);
    world.camera_normal = scene.camera_normal;
    world.background = scene.background;
    if (scene.language_version < 3.7)  // it was always seen
        world.background.colour.filter = world.background.colour.transmit = 0;
    world.sky = scene.sky;
    if (world.quality >= quality_full) {
        world.fogs = scene.fogs;
        world.rainbows = scene.rainbows;
    }
    flatten(scene, world, diagnostics, what, options.remembers_objects);
    simplify_lights(world);
    return world;
}

/// Around all points that lie inside of a primitive that is no face, or of a composite.
Box inside_box(const World& world, std::uint32_t item) {
    if (item < world.spheres.size()) return item_bounds(world, item);
    if (item >= world.leaves_begin())
        return world.composites[item - world.leaves_begin()].composite->inside_bounds();
    const PlacedShape& placed = world.shapes[item - world.spheres.size() - world.triangles.size()];
    const Box box = inside_bounds(placed.shape);
    return placed.transform ? placed.transform->box(box) : box;
}

ClearSolids find_clear_solids(const World& world) {
    ClearSolids clear;
    std::vector<Box> around;
    for (std::uint32_t item = 0; item < item_count(world); ++item) {
        if (!world.is_noted_solid(item)) continue;
        const Box box = inside_box(world, item);
        if (box.empty()) continue;
        if (!finite(box)) {
            clear.unbounded.push_back(item);
        } else {
            clear.bounded.push_back(item);
            around.push_back(box);
        }
    }
    clear.index = PartIndex(std::move(around), world.settings.index);
    return clear;
}

void note_luminaires(World& world) {
    if (world.luminaires.empty()) return;
    world.luminaire_of.assign(world.material_of.size(), no_primitive);
    for (LightIndex light = 0; light < world.luminaires.size(); ++light)
        world.luminaire_of[world.luminaires[light].primitive] = light;
}

/// Finds out where luminaires are bright whose glow varies, unless they are too many.
void map_brightness(World& world) {
    // Points that are asked for their glow, and the fewest cells that tell something.
    constexpr double most_points = 1 << 19, least_cells = 4;
    double faces = 0;
    for (const Luminaire& luminaire : world.luminaires)
        if (luminaire.varying) faces += static_cast<double>(face_count(luminaire.emitter));
    const double cells = std::fmin(std::sqrt(most_points / (4 * faces)), Brightness::most_cells);
    if (!(faces > 0 && cells >= least_cells)) return;
    for (Luminaire& luminaire : world.luminaires)
        if (luminaire.varying && face_count(luminaire.emitter) > 0)
            luminaire.brightness =
                brightness_of(luminaire, static_cast<int>(cells), [&](const Vec3& point) {
                    return luminance(world.emission(luminaire.primitive, point));
                });
}

/// Between the rays through the middles of two pixels in the middle of the picture.
double pixel_angle(const Projection& camera, const CompileOptions& options) {
    const Vec3 middle = camera.ray(0, 0).direction;
    const double across = length(camera.ray(1.0 / options.width, 0).direction - middle),
                 down = length(camera.ray(0, 1.0 / options.height).direction - middle);
    return std::sqrt(across * down);
}

/// What a flattened world still lacks.
void build_indices(World& world, const CompileOptions& options) {
    if (options.light_sampler) world.settings.light_sampler = *options.light_sampler;
    note_planes(world);
    build_index(world, options.threads);
    if (world.notes_solids() && world.camera.parallel)
        world.clear_solids = find_clear_solids(world);
    note_luminaires(world);
    map_brightness(world);
    if (world.sky && world.sky->luminaire && world.quality >= quality_shadows)
        world.sky_light =
            SkyLight([&](const Vec3& direction) { return world.sky_radiance(direction); });
    // After the tree, whose building takes the most memory.
    std::vector<Box> boxes(item_count(world));
    for (std::uint32_t item = 0; item < boxes.size(); ++item)
        boxes[item] = bounds_in_tree(world, item);
    const std::vector<Plane> planes = world_planes(world);
    LightScene lit{world.luminaires, boxes, planes};
    lit.pixel = pixel_angle(world.camera, options);
    if (!world.camera.parallel) lit.eye = world.camera.location;
    const auto* octree = std::get_if<LightOctree>(&world.settings.light_sampler);
    if (octree && !octree->paper) find_leans(world, lit.eye, options.threads);
    world.sampler = build(world.settings.light_sampler, lit, options.threads);
    std::vector<std::uint32_t> group_of;
    for (const LightReach& reach : world.light_reach) group_of.push_back(reach.group);
    world.source_sets =
        source_sets(world.lights, group_of, world.settings.light_sampler, lit,
                    world.left_to_chance() ? most_asked_among_samples : most_asked_sources);
}

}  // namespace

World survey(const Scene& scene, Diagnostics& diagnostics) {
    CompileOptions full;
    full.quality = quality_full;
    return flattened(scene, full, Flatten::luminaires, diagnostics);
}

World compile(const Scene& scene, const CompileOptions& options, Diagnostics& diagnostics) {
    World world = flattened(scene, options, Flatten::everything, diagnostics);
    build_indices(world, options);
    return world;
}

World compile(Scene&& scene, const CompileOptions& options, Diagnostics& diagnostics) {
    World world = flattened(scene, options, Flatten::everything, diagnostics);
    scene.objects = {};
    build_indices(world, options);
    return world;
}
