// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/shot.h"

#include "base/degrees.h"
#include "base/elementary.h"
#include "lighting/joined_lights.h"
#include "shape/transformed.h"
#include "world/bent_normals.h"
#include "world/luminaire_choices.h"
#include "world/media_choices.h"
#include "world/sky_choice.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace candelabra {

namespace {

/// Fraction of the rays of a luminaire that are emitted to its inside, where its light stays and
/// the camera is not.
constexpr double rare_inner_rays = 1.0 / 16;

WorldView view_of(const WorldView& stated, const Projection& camera) {
    return {camera, stated.camera_normal, film_in(camera, stated.film)};
}

/// Box around the camera and all that glows, or around all finite items if nothing glows.
Box near_camera_and_lamps(const World& world, const Projection& camera) {
    Box box;
    if (!world.facts.has_media) return box;
    world.lights.for_each_glowing([&](const auto& each) { box = join(box, bounds(each).box); });
    if (box.empty())
        for (std::uint32_t item = 0; item < world.geometry.item_count(); ++item)
            box = join(box, world.geometry.finite_bounds(item));
    return join(box, camera.location);
}

/// The planes of a scene in world space: besides bounded primitives, points to be lit may lie on
/// them.
std::vector<Plane> world_planes(const Geometry& geometry) {
    std::vector<Plane> planes;
    for (const std::uint32_t item : geometry.infinite.all) {
        const PlacedShape* placed = geometry.shape(item);
        const Plane* plane = placed ? std::get_if<Plane>(&placed->shape) : nullptr;
        if (!plane) continue;
        planes.push_back(placed->transform ? transformed(*plane, *placed->transform)
                                           : Plane{unit(plane->normal), plane->distance});
    }
    return planes;
}

/// Angle between rays through adjacent pixel centres in the middle of the picture.
double pixel_angle(const Projection& camera, const ShotSettings& settings) {
    const Vec3 middle = camera.ray(0, 0).direction;
    const double across = length(camera.ray(1.0 / settings.width, 0).direction - middle),
                 down = length(camera.ray(0, 1.0 / settings.height).direction - middle);
    return std::sqrt(across * down);
}

/// Size of the place where the rays of a camera without an eye start.
double view_size(const Projection& camera) {
    Box starts;
    for (const double u : {-0.5, 0.0, 0.5})
        for (const double v : {-0.5, 0.0, 0.5}) {
            const Ray ray = camera.ray(u, v);
            if (ray.direction != Vec3(0)) starts = join(starts, ray.origin);
        }
    return starts.empty() ? 0 : length(starts.size());
}

/// Where the camera looks from, without lights and surfaces.
LightScene seen_by(const Projection& camera, const ShotSettings& settings) {
    LightScene scene;
    scene.pixel = pixel_angle(camera, settings);
    if (camera.parallel)
        scene.view = view_size(camera);
    else
        scene.eye = camera.location;
    if (camera.lens == Lens::parallel && !camera.mesh) scene.axis = camera.ray(0, 0);
    return scene;
}

BuiltLightSampler hierarchy_of(const ChoosableLights& lights) {
    return lights.size() > 0 ? BuiltLightSampler(BuiltLightBvh(lights)) : BuiltLightSampler();
}

/// Luminaires and boxes of media, as WorldLights counts them. `bent_normals`: of each; empty: none
/// has one. `sky`: chosen besides; null: none.
std::shared_ptr<const ChoosableLights> glowing_choices(const WorldLights& lights,
                                                       std::span<const Vec3> bent_normals,
                                                       std::unique_ptr<const ChoosableSky> sky) {
    const std::size_t count = bent_normals.empty() ? 0 : lights.luminaires.size();
    const auto luminaires = std::make_shared<LuminaireChoices>(
        lights.luminaires, bent_normals.first(count), std::move(sky));
    if (lights.media.empty()) return luminaires;
    return std::make_shared<JoinedLights>(
        luminaires, std::make_shared<MediaChoices>(lights.media, bent_normals.subspan(count)));
}

/// Sets the samplers to those that need no survey.
void choose_quickly(Shot& shot) {
    const WorldLights& lights = shot.world->lights;
    shot.sampler = hierarchy_of(*glowing_choices(lights, {}, nullptr));
    for (const SourceSet& set : lights.source_sets)
        shot.of_sources.push_back(set.drawn() ? hierarchy_of(*set.choices) : BuiltLightSampler());
}

/// The set of sources among which and what glows one draw chooses; null: there is none. It
/// makes less noise than a draw for each kind: "One draw" in tests/bench/README.md. Where a surface
/// or a photon takes light of luminaires alone, sources would be drawn in vain.
const SourceSet* joined_set(const World& world, const ChoosableLights& glowing) {
    const bool apart = world.facts.gathers_light || !world.photon_targets.empty() ||
                       !traits(world.rules.settings.light_sampler).weighs_falloff;
    if (apart || (glowing.size() == 0 && !glowing.sky())) return nullptr;
    const auto& sets = world.lights.source_sets;
    const auto found = std::ranges::find_if(sets, &SourceSet::can_be_joined);
    return found == sets.end() ? nullptr : &*found;
}

/// Sets the samplers to those that the scene wants.
void choose_as_wanted(Shot& shot, const ShotSettings& settings) {
    const World& world = *shot.world;
    const LightSampler& wanted = world.rules.settings.light_sampler;
    LightScene scene = seen_by(shot.view.camera, settings);
    if (traits(wanted).wants_bent_normals)
        shot.bent_normals = find_bent_normals(world, scene.eye, shot.pixels, settings.threads);
    std::vector<Box> boxes(world.geometry.item_count());
    for (std::uint32_t item = 0; item < boxes.size(); ++item)
        boxes[item] = world.geometry.finite_bounds(item);
    const std::vector<Plane> planes = world_planes(world.geometry);
    auto sky = world.sky.light.empty() ? nullptr : std::make_unique<SkyChoice>(world);
    if (sky && sky->glares()) sky = nullptr;
    const auto glowing = glowing_choices(world.lights, shot.bent_normals, std::move(sky));
    shot.joined = joined_set(world, *glowing);
    scene.lights = glowing;
    if (shot.joined) scene.lights = std::make_shared<JoinedLights>(glowing, shot.joined->choices);
    scene.surfaces = boxes;
    scene.planes = planes;
    shot.sampler = build(wanted, scene, settings.threads);
    for (const SourceSet& set : world.lights.source_sets)
        shot.of_sources.push_back(set.drawn() && &set != shot.joined
                                      ? build(wanted, light_scene(set, scene), settings.threads)
                                      : BuiltLightSampler());
}

}  // namespace

FilmSettings film_in(const Projection& camera, const FilmSettings& stated) {
    FilmSettings film = stated;
    const bool flat = camera.lens == Lens::flat;
    if (!film.glares || film.glare.field > 0 || !flat) return film;
    const double across = length(camera.right) / 2, ahead = length(camera.direction);
    constexpr double widest = 170;
    film.glare.field = std::min(2 * math::atan2(across, ahead) / radians_per_degree, widest);
    return film;
}

Shot::Shot(SharedWorld seen, const ShotSettings& settings)
    : Shot(std::move(seen), settings, [](const Projection& stated) { return stated; }) {}

Shot::Shot(SharedWorld seen, const ShotSettings& settings, Placed placed)
    : world(std::move(seen)),
      view(view_of(world->stated_view, placed(world->stated_view.camera))),
      pixels(static_cast<std::uint64_t>(settings.width) *
             static_cast<std::uint64_t>(settings.height)),
      near(near_camera_and_lamps(*world, view.camera)) {
    if (settings.quick)
        choose_quickly(*this);
    else
        choose_as_wanted(*this, settings);
    later.reserve(world->shutter.size());
    for (const World& moment : world->shutter)
        later.emplace_back(SharedWorld(world, &moment), settings, placed);
}

Lamp Shot::lamp(LightIndex light) const {
    const std::size_t glowing = world->lights.glowing();
    return light < glowing ? Lamp::luminaire(light) : Lamp::source(joined->lights[light - glowing]);
}

double Shot::inner_rays(const Luminaire& luminaire) const {
    const bool rare = luminaire.keeps_inner_light &&
                      !world->contains_point(luminaire.primitive, view.camera.location);
    return rare ? rare_inner_rays : 0.5;
}

}  // namespace candelabra
