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
    return world.geometry.leaves_begin() +
           static_cast<std::uint32_t>(world.geometry.composites.size());
}

/// Empty for what has no end.
Box bounds_in_tree(const World& world, std::uint32_t item) {
    return std::ranges::binary_search(world.geometry.unbounded, item) ? Box()
                                                                      : item_bounds(world, item);
}

Box part_in_tree(const World& world, std::uint32_t item, const Box& cell) {
    if (item < world.geometry.spheres.size()) {
        const SpherePrimitive& s = world.geometry.spheres[item];
        return clipped_bounds(Sphere{s.centre, s.radius}, cell);
    }
    if (item >= world.geometry.leaves_begin()) return cell;
    const std::size_t face = item - world.geometry.spheres.size();
    if (face < world.geometry.triangles.size()) {
        const TrianglePrimitive& t = world.geometry.triangles[face];
        return clipped_bounds(Triangle{t.corner1, t.corner2, t.corner3}, cell);
    }
    const PlacedShape& placed = world.geometry.shapes[face - world.geometry.triangles.size()];
    return clipped_bounds(stick_around(placed.shape, bounds(placed.shape), placed.transform.get()),
                          cell);
}

void build_index(World& world, int threads) {
    world.geometry.tree = build_tree(
        item_count(world), [&](std::uint32_t item) { return bounds_in_tree(world, item); },
        [&](std::uint32_t item, const Box& cell) { return part_in_tree(world, item, cell); },
        tree_settings(world.rules.settings.index), threads);
    const auto spheres = static_cast<std::uint32_t>(world.geometry.spheres.size());
    const auto faces = static_cast<std::uint32_t>(world.geometry.triangles.size());
    const PackedKinds kinds{spheres, spheres + faces,
                            [&](std::uint32_t item) {
                                return PackedKinds::Ball{world.geometry.spheres[item].centre,
                                                         world.geometry.spheres[item].radius};
                            },
                            [&](std::uint32_t item) {
                                const TrianglePrimitive& t =
                                    world.geometry.triangles[item - spheres];
                                return std::array{t.corner1, t.corner2, t.corner3};
                            },
                            [&](std::uint32_t item) { return item_bounds(world, item); }};
    world.geometry.tree.pack(leaf_packs(kinds), threads);
}

/// The planes of a scene in world space: where points to be lit may be, besides the bounded
/// primitives.
std::vector<Plane> world_planes(const World& world) {
    std::vector<Plane> planes;
    for (const std::uint32_t primitive : world.geometry.unbounded) {
        if (primitive >= world.geometry.leaves_begin()) continue;
        const PlacedShape& placed =
            world.geometry.shapes[primitive - world.geometry.shapes_begin()];
        const Plane* plane = std::get_if<Plane>(&placed.shape);
        if (!plane) continue;
        planes.push_back(placed.transform ? moved(*plane, *placed.transform)
                                          : Plane{unit(plane->normal), plane->distance});
    }
    return planes;
}

/// Divides what has no end into planes and others.
void note_planes(World& world) {
    for (const std::uint32_t item : world.geometry.unbounded) {
        const std::size_t shape = item - world.geometry.shapes_begin();
        const Plane* plane =
            shape < world.geometry.shapes.size() && !world.geometry.shapes[shape].transform
                ? std::get_if<Plane>(&world.geometry.shapes[shape].shape)
                : nullptr;
        if (!plane) {
            world.geometry.endless.push_back(item);
            continue;
        }
        Crossings found;
        crossings(*plane, {Vec3(0), plane->normal}, found);
        world.geometry.planes.push_back({found[0].normal, plane->distance, item});
    }
}

/// Lights as they are seen at a quality.
void simplify_lights(World& world) {
    if (world.rules.quality < quality_light) {
        world.lights.sources.clear();
        world.lights.reach.clear();
    }
    if (world.rules.quality < quality_shadows)
        for (LightReach& reach : world.lights.reach) reach.window = nullptr;
    if (world.rules.quality >= quality_areas) return;
    for (Light& light : world.lights.sources)
        std::visit([](auto& l) { l.size1 = l.size2 = 0; }, light);
}

World flattened(const Scene& scene, const CompileOptions& options, Flatten what,
                Diagnostics& diagnostics) {
    World world;
    world.rules.quality = options.quality;
    world.rules.settings = scene.settings;
    if (options.index) world.rules.settings.index = *options.index;
    world.rules.language_version = scene.language_version;
    world.view.camera = projection(scene.camera);
    world.view.camera_normal = scene.camera_normal;
    world.sky.background = scene.background;
    if (scene.language_version < 3.7)  // it was always seen
        world.sky.background.colour.filter = world.sky.background.colour.transmit = 0;
    world.sky.sphere = scene.sky;
    if (world.rules.quality >= quality_full) {
        world.sky.fogs = scene.fogs;
        world.sky.rainbows = scene.rainbows;
    }
    flatten(scene, world, diagnostics, what, options.remembers_objects);
    simplify_lights(world);
    return world;
}

/// Around all points that lie inside of a primitive that is no face, or of a composite.
Box inside_box(const World& world, std::uint32_t item) {
    if (item < world.geometry.spheres.size()) return item_bounds(world, item);
    if (item >= world.geometry.leaves_begin())
        return world.geometry.composites[item - world.geometry.leaves_begin()]
            .composite->inside_bounds();
    const PlacedShape& placed = world.geometry.shapes[item - world.geometry.shapes_begin()];
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
    clear.index = PartIndex(std::move(around), world.rules.settings.index);
    return clear;
}

void note_luminaires(World& world) {
    if (world.lights.luminaires.empty()) return;
    world.lights.luminaire_of.assign(world.appearance.material_of.size(), no_primitive);
    for (LightIndex light = 0; light < world.lights.luminaires.size(); ++light)
        world.lights.luminaire_of[world.lights.luminaires[light].primitive] = light;
}

/// Finds out where luminaires are bright whose glow varies, unless they are too many.
void map_brightness(World& world) {
    // Points that are asked for their glow, and the fewest cells that tell something.
    constexpr double most_points = 1 << 19, least_cells = 4;
    double faces = 0;
    for (const Luminaire& luminaire : world.lights.luminaires)
        if (luminaire.varying) faces += static_cast<double>(face_count(luminaire.emitter));
    const double cells = std::fmin(std::sqrt(most_points / (4 * faces)), Brightness::most_cells);
    if (!(faces > 0 && cells >= least_cells)) return;
    for (Luminaire& luminaire : world.lights.luminaires)
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
    if (options.light_sampler) world.rules.settings.light_sampler = *options.light_sampler;
    note_planes(world);
    build_index(world, options.threads);
    if (world.notes_solids() && world.view.camera.parallel)
        world.geometry.clear_solids = find_clear_solids(world);
    note_luminaires(world);
    map_brightness(world);
    if (world.sky.sphere && world.sky.sphere->luminaire && world.rules.quality >= quality_shadows)
        world.sky.light =
            SkyLight([&](const Vec3& direction) { return world.sky_radiance(direction); });
    // After the tree, whose building takes the most memory.
    std::vector<Box> boxes(item_count(world));
    for (std::uint32_t item = 0; item < boxes.size(); ++item)
        boxes[item] = bounds_in_tree(world, item);
    const std::vector<Plane> planes = world_planes(world);
    LightScene lit{world.lights.luminaires, boxes, planes};
    lit.pixel = pixel_angle(world.view.camera, options);
    if (!world.view.camera.parallel) lit.eye = world.view.camera.location;
    const auto* octree = std::get_if<LightOctree>(&world.rules.settings.light_sampler);
    if (octree && !octree->paper) find_leans(world, lit.eye, options.threads);
    world.lights.sampler = build(world.rules.settings.light_sampler, lit, options.threads);
    std::vector<std::uint32_t> group_of;
    for (const LightReach& reach : world.lights.reach) group_of.push_back(reach.group);
    world.lights.source_sets =
        source_sets(world.lights.sources, group_of, world.rules.settings.light_sampler, lit,
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
