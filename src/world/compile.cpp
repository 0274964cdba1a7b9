// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/compile.h"

#include "csg/assemble.h"
#include "index/tree_builder.h"
#include "luminaire/brightness.h"
#include "shape/leaf_pack.h"
#include "shape/segment_bound.h"
#include "shape/transformed.h"
#include "surface/quality.h"
#include "world/emitters.h"
#include "world/flatten.h"
#include "world/luminaire_choices.h"
#include "world/prototype.h"
#include "world/radiance.h"
#include "world/review.h"
#include "world/shutter.h"
#include "world/volumes.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace candelabra {

namespace {

Box part_in_tree(const Geometry& geometry, std::uint32_t item, const Box& cell) {
    if (geometry.instance(item)) return clip(geometry.bounds(item), cell);
    return geometry.visit(
        item,
        [&](const SpherePrimitive& s) {
            return clipped_bounds(Sphere{s.centre, s.radius}, cell);
        },
        [&](const TrianglePrimitive& t) {
            return clipped_bounds(Triangle{t.corner1, t.corner2, t.corner3}, cell);
        },
        [&](const PlacedShape& placed) {
            return clipped_bounds(
                stick_around(placed.shape, bounds(placed.shape), placed.transform.get()), cell);
        },
        [&](const PlacedComposite&) { return cell; });
}

/// Instances often overlap, and to test one again takes longer than to test many boxes. So where
/// most items are instances, a kd-tree cuts few of them.
TreeSettings settings_for(const Geometry& geometry, const RayIndex& index) {
    constexpr double cost_of_instance = 500;  // beside that of another item
    TreeSettings settings = tree_settings(index);
    if (2 * geometry.instances.size() > geometry.item_count())
        settings.reference_cost *= cost_of_instance;
    return settings;
}

void build_index(Geometry& geometry, const RayIndex& index, int threads) {
    for (const auto& prototype : geometry.prototypes)
        build_index(prototype->geometry, index, threads);
    geometry.tree = build_tree(
        geometry.item_count(), [&](std::uint32_t item) { return geometry.finite_bounds(item); },
        [&](std::uint32_t item, const Box& cell) { return part_in_tree(geometry, item, cell); },
        settings_for(geometry, index), threads);
    const PackedKinds kinds{
        geometry.triangles_begin(), geometry.shapes_begin(),
        [&](std::uint32_t item) {
            return PackedKinds::Ball{geometry.spheres[item].centre, geometry.spheres[item].radius};
        },
        [&](std::uint32_t item) {
            const TrianglePrimitive& t = geometry.triangle(item);
            return std::array{t.corner1, t.corner2, t.corner3};
        },
        [&](std::uint32_t item) { return geometry.bounds(item); }};
    geometry.tree.pack(leaf_packs(kinds), threads);
}

/// Divides the infinite items into planes and others.
void divide(const Geometry& geometry, InfiniteItems& infinite) {
    for (const std::uint32_t item : infinite.all) {
        const PlacedShape* placed = geometry.shape(item);
        const Plane* plane =
            placed && !placed->transform ? std::get_if<Plane>(&placed->shape) : nullptr;
        if (!plane) {
            infinite.others.push_back(item);
            continue;
        }
        Crossings found;
        crossings(*plane, {Vec3(0), plane->normal}, found);
        infinite.planes.push_back({found[0].normal, plane->distance, item});
    }
}

/// Simplifies lights to those of the quality level.
void simplify_lights(World& world) {
    if (world.rules.quality < quality_light) {
        world.lights.sources.clear();
        world.lights.reach.clear();
    }
    if (world.rules.quality < quality_shadows)
        for (LightReach& reach : world.lights.reach) reach.window = nullptr;
    if (world.rules.quality >= quality_areas) return;
    for (PointLight& light : world.lights.sources) light.size1 = light.size2 = 0;
}

/// The brightness of a pigment in the cells of a lens, over the square from 0 to x + y.
std::vector<double> lens_brightness(const Pigment& pigment, const World& world) {
    std::vector<double> brightness;
    for (int row = 0; row < lens_cells; ++row)
        for (int column = 0; column < lens_cells; ++column)
            brightness.push_back(grey(
                evaluate(pigment, Vec3((column + 0.5) / lens_cells, (row + 0.5) / lens_cells, 0),
                         world.pattern_scene())
                    .rgb));
    return brightness;
}

World flattened(const Scene& scene, const CompileOptions& options, Flatten what,
                Diagnostics& diagnostics) {
    World world;
    world.rules.quality = options.quality;
    world.rules.settings = scene.settings;
    if (options.index) world.rules.settings.index = *options.index;
    world.rules.language_version = scene.language_version;
    world.stated_view = {projection(scene.camera), scene.camera_normal, scene.film};
    if (scene.bokeh && world.stated_view.camera.lens_radius > 0)
        world.stated_view.camera.lens_shape = LensShape(lens_brightness(*scene.bokeh, world));
    world.sky.background = scene.background;
    if (scene.language_version < 3.7)  // the background was always visible
        world.sky.background.colour.filter = world.sky.background.colour.transmit = 0;
    world.sky.sphere = scene.sky;
    if (scene.daylight)
        world.sky.daylight = DaylightSky(*scene.daylight, world.rules.settings.light_units());
    world.provenance.sky = scene.daylight ? scene.daylight_statement : scene.sky_statement;
    if (world.rules.quality >= quality_full) {
        world.sky.fogs = scene.fogs;
        world.sky.rainbows = scene.rainbows;
        world.sky.media = scene.media;
    }
    world.facts = facts_of(world);  // flatten() asks about the settings
    for (Media& media : world.sky.media)
        media.scattering.physical = media.scattering.multiple && world.facts.keeps_energy;
    flatten(scene, world, diagnostics,
            {what, options.remembers_objects, options.follows_lamps, options.instances});
    simplify_lights(world);
    world.facts = facts_of(world);
    find_openings(world);
    return world;
}

ClearSolids find_clear_solids(const World& world) {
    ClearSolids clear;
    std::vector<Box> around;
    for (std::uint32_t item = 0; item < world.geometry.item_count(); ++item) {
        if (!world.is_noted_solid(item)) continue;
        const Box box = world.geometry.noticed_in(item);
        if (box.empty()) continue;
        if (!finite(box)) {
            clear.infinite.push_back(item);
        } else {
            clear.finite.push_back(item);
            around.push_back(box);
        }
    }
    clear.index = PartIndex(std::move(around), world.rules.settings.index);
    return clear;
}

/// Builds what strategies ask of the luminaires of each prototype.
void build_prototype_lights(World& world, int threads) {
    if (world.lights.luminaires.placed().empty()) return;
    for (const auto& prototype : world.geometry.prototypes) {
        for (const Luminaire& luminaire : prototype->luminaires) {
            prototype->luminance = std::max(prototype->luminance, bounds(luminaire).luminance);
        }
        prototype->lights = LightTree(LuminaireChoices(prototype->luminaires), threads);
    }
}

void note_luminaires(World& world) {
    if (world.lights.luminaires.empty()) return;
    world.lights.luminaire_of.assign(world.appearance.material_of.size(), no_primitive);
    LightIndex light = 0;
    for (const Luminaire& luminaire : world.lights.luminaires.own())
        world.lights.luminaire_of[luminaire.primitive] = light++;
}

/// Maps the brightness of luminaires whose emission varies, unless they are too many.
void map_brightness(World& world) {
    // Number of points at which emission is evaluated, and the fewest cells that are useful.
    constexpr double max_points = 1 << 19, min_cells = 4;
    double faces = 0;
    for (const Luminaire& luminaire : world.lights.luminaires.own())
        if (luminaire.varying) faces += static_cast<double>(face_count(luminaire.emitter));
    const double cells = std::fmin(std::sqrt(max_points / (4 * faces)), Brightness::max_cells);
    if (!(faces > 0 && cells >= min_cells)) return;
    for (Luminaire& luminaire : world.lights.luminaires.own())
        if (luminaire.varying && face_count(luminaire.emitter) > 0)
            luminaire.brightness = brightness_of(
                luminaire, static_cast<int>(cells),
                [&](const Vec3& point) { return luminance_at(world, luminaire.primitive, point); });
}

/// Makes a lamp of the sky if it is a luminaire.
void light_the_sky(World& world) {
    const bool painted = world.sky.sphere && world.sky.sphere->luminaire;
    if (!painted && !world.sky.daylight) return;
    if (world.rules.quality < quality_shadows) return;
    world.sky.light =
        SkyLight([&](const Vec3& direction) { return world.sky_radiance(direction); });
    if (world.sky.light.empty()) return;
    Provenance& provenance = world.provenance;
    provenance.statement_of_sky = static_cast<std::uint32_t>(provenance.light_statements.size());
    // The sun has a light of its own by the same statement.
    provenance.add_light_statement(provenance.sky, world.sky.daylight ? "sky" : "");
}

/// Divides the light sources into sets.
void divide_sources(World& world) {
    std::vector<std::uint32_t> group_of;
    for (const LightReach& reach : world.lights.reach) group_of.push_back(reach.group);
    const bool random = facts_of(world).differs_by_light;
    world.lights.source_sets =
        source_sets(world.lights.sources, group_of, world.rules.settings.light_sampler,
                    random ? max_asked_among_samples : max_asked_sources);
    world.facts = facts_of(world);  // light sources may be drawn
}

/// Builds the index structures of a flattened world.
void build_indices(World& world, const CompileOptions& options) {
    if (options.light_sampler) world.rules.settings.light_sampler = *options.light_sampler;
    divide(world.geometry, world.geometry.infinite);
    build_index(world.geometry, world.rules.settings.index, options.threads);
    if (world.facts.notes_solids && world.facts.indexes_solids)
        world.geometry.clear_solids = find_clear_solids(world);
    note_luminaires(world);
    build_prototype_lights(world, options.threads);
    map_brightness(world);
    light_the_sky(world);
    divide_sources(world);
}

/// Warns of probable mistakes. Mistakes in a scene do not depend on the quality of its picture, nor
/// on whether a surface shows the light of its luminaires, without which these are left out.
void review(const Scene& scene, const World& world, const CompileOptions& options,
            Diagnostics& diagnostics) {
    const bool whole = options.quality >= quality_full &&
                       (options.follows_lamps || !scene.meters.empty() || receives_light(world));
    review(scene, whole ? world : *survey(scene, diagnostics), diagnostics);
}

/// Compiles the scene, and discards its objects on the way.
World compiled(Scene& scene, const CompileOptions& options, Diagnostics& diagnostics) {
    World world = flattened(scene, options, Flatten::everything, diagnostics);
    if (options.reviews) review(scene, world, options, diagnostics);
    scene.objects = {};
    build_indices(world, options);
    return world;
}

void add_shutter_samples(World& world, const View& view, const CompileOptions& options,
                         const ShutterScenes& scenes) {
    CompileOptions unreviewed = options;
    unreviewed.reviews = false;
    for (int i = 1; view.shutter > 0 && i < view.moments; ++i) {
        std::optional<Scene> scene = scenes.scene_at(view.shutter * i / view.moments);
        if (!scene) break;
        Diagnostics said_of_the_first;
        world.shutter.push_back(compiled(*scene, unreviewed, said_of_the_first));
    }
    world.facts = facts_of(world);
    share_light_statements(world, scenes.sources);
}

}  // namespace

SharedWorld survey(const Scene& scene, Diagnostics& diagnostics) {
    CompileOptions full;
    full.quality = quality_full;
    return std::make_shared<World>(flattened(scene, full, Flatten::luminaires, diagnostics));
}

SharedWorld compile(const Scene& scene, const CompileOptions& options, Diagnostics& diagnostics) {
    World world = flattened(scene, options, Flatten::everything, diagnostics);
    build_indices(world, options);
    return std::make_shared<World>(std::move(world));
}

SharedWorld compile(Scene&& scene, const CompileOptions& options, Diagnostics& diagnostics,
                    const ShutterScenes* shutter) {
    World world = compiled(scene, options, diagnostics);
    const View& view =
        std::visit([](const auto& camera) -> const View& { return camera; }, scene.camera);
    if (shutter) add_shutter_samples(world, view, options, *shutter);
    return std::make_shared<World>(std::move(world));
}

}  // namespace candelabra
