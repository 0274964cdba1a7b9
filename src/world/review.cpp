// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/review.h"

#include "csg/extent.h"
#include "csg/solid.h"
#include "luminaire/luminaire.h"
#include "text/message.h"
#include "world/prototype.h"
#include "world/radiance.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace candelabra {

namespace {

/// Minimum ambient of a surface that is meant to be seen by its ambient colour alone.
constexpr double noticeable_ambient = 0.3;

double greatest(const Rgb& c) { return std::max({c.r, c.g, c.b}); }

bool shows_itself(const Texture& texture) {
    return texture.choice || texture.below ||
           greatest(texture.finish.ambient) >= noticeable_ambient;
}

bool shows_itself(const Material& material) {
    return shows_itself(*material.texture) || (material.inner && shows_itself(*material.inner));
}

bool dark(const World& world) {
    const auto black = [](const PointLight& light) { return light.colour == Rgb(0); };
    return std::ranges::all_of(world.lights.sources, black) && !world.lights.any_glowing() &&
           !world.sky.sphere && !world.sky.daylight &&
           greatest(world.sky.background.radiance()) <= 0 &&
           std::ranges::none_of(world.appearance.materials,
                                [](const Material& m) { return shows_itself(m); });
}

/// Whether it glows, but with black.
bool glows_black(const Material& material) {
    const bool glows = material.texture->finish.emission != Rgb(0) ||
                       (material.inner && material.inner->finish.emission != Rgb(0));
    return glows && greatest(greatest_emission(material)) <= 0;
}

class Surroundings {
public:
    Surroundings(const Scene& scene, const World& world) : scene_(scene), world_(world) {}

    /// Returns the first solid of the scene that contains the camera, is not `hollow`, and changes
    /// the picture by keeping out fog, media or all light. Null: none.
    const Object* first() {
        const Vec3 camera = world_.stated_view.camera.location;
        for (const ObjectHandle& object : scene_.objects)
            if (!object->hollow && !object->no_image && surrounds(object, camera) &&
                (world_.facts.dims_between || keeps_light_out(object)))
                return object.get();
        return nullptr;
    }

private:
    bool surrounds(const ObjectHandle& object, const Vec3& point) {
        return may_hold(*object, point) && has_inside(*object) && holds(object, point);
    }

    /// Whether the scene is lit, and only from outside of the object: rooms and skies contain their
    /// lights.
    bool keeps_light_out(const ObjectHandle& object) {
        if (object->no_shadow || (object->texture && transparent(*object->texture))) return false;
        const auto reaches = [&](const PlacedLight& placed) {
            const auto& light = placed.light;
            return light.shadowless || (!light.along_axis() && surrounds(object, light.location));
        };
        const auto within = [&](const auto& each) {
            return surrounds(object, bounds(each).centre);
        };
        const bool lit = !scene_.lights.empty() || world_.lights.any_glowing() ||
                         world_.sky.sphere || world_.sky.daylight;
        return lit && std::ranges::none_of(scene_.lights, reaches) &&
               !world_.lights.luminaires.any_of(within) &&
               std::ranges::none_of(world_.lights.media, within);
    }

    /// A quick test that excludes most objects.
    static bool may_hold(const Object& object, const Vec3& point) {
        if (object.inverse) return contains(bounds_of_inside(object), point);
        const Vec3 within = object.transform ? object.transform->inverse_point(point) : point;
        const auto* shape = std::get_if<Shape>(&object.form);
        const auto* sphere = shape ? std::get_if<Sphere>(shape) : nullptr;
        return sphere ? length(within - sphere->centre) < sphere->radius
                      : contains(own_extent(object), within);
    }

    /// Unions and rows are tested part by part, without making them one solid for a single point.
    bool holds(const ObjectHandle& object, const Vec3& point) {
        const auto* group = std::get_if<Union>(&object->form);
        const auto* row = std::get_if<SphereRow>(&object->form);
        const bool parts = row || (group && group->csg == Csg::together);
        if (!parts || object->clipping || object->inverse) return solids_.inside(object, point);
        const Vec3 within = object->transform ? object->transform->inverse_point(point) : point;
        if (row)
            return std::ranges::any_of(row->spheres,
                                       [&](const Sphere& each) { return inside(each, within); });
        return std::ranges::any_of(group->children, [&](const ObjectHandle& child) {
            return may_hold(*child, within) && holds(child, within);
        });
    }

    const Scene& scene_;
    const World& world_;
    Solids solids_;
};

/// Returns a luminous dome around the camera, which is only a backdrop in POV-Ray.
std::optional<LightIndex> dome(const World& world) {
    const Vec3 camera = world.stated_view.camera.location;
    const auto within = [&](const Luminaire& luminaire) {
        const auto* sphere = std::get_if<SphereEmitter>(&luminaire.emitter);
        const auto* composite = std::get_if<CompositeEmitter>(&luminaire.emitter);
        const bool turned = composite && composite->composite->leaf_count() == 1,
                   hidden = world.material(luminaire.primitive).no_image;
        return sphere ? length(camera - sphere->centre) < sphere->radius
                      : (turned || hidden) && contains(bounds(luminaire).box, camera);
    };
    const LuminaireList& all = world.lights.luminaires;
    for (LightIndex light = 0; light < all.own().size(); ++light)
        if (within(all.own()[light])) return light;
    for (const PlacedLuminaires& placed : all.placed()) {
        if (!contains(placed.place->box(placed.prototype->box), camera)) continue;
        const auto end =
            placed.first + static_cast<LightIndex>(placed.prototype->luminaires.size());
        for (LightIndex light = placed.first; light < end; ++light)
            if (within(*all[light])) return light;
    }
    return std::nullopt;
}

/// Returns a ratio of lengths as people write it: `16:9`, or `2.39:1` if small numbers do not do.
std::string ratio_text(double ratio) {
    constexpr double close = 0.004;  // 1.33, the default of cameras, is called 4:3
    for (int down = 1; down <= 16; ++down) {
        const double across = std::round(ratio * down);
        if (across >= 1 && across <= 21 && std::abs(across / down / ratio - 1) < close)
            return message(across, ':', down);
    }
    const double hundredths = std::round(100 * (ratio < 1 ? 1 / ratio : ratio)) / 100;
    return ratio < 1 ? message("1:", hundredths) : message(hundredths, ":1");
}

}  // namespace

void review_shape(const Scene& scene, int width, int height, Diagnostics& diagnostics) {
    if (!scene.camera_given) return;
    const Projection seen = projection(scene.camera);
    const std::optional<double> stretched = pixel_aspect(seen, width, height);
    constexpr double noticeable = 0.02;
    constexpr int smallest = 32;  // shapes of icons and of tests are not looked at
    if (std::max(width, height) < smallest) return;
    if (!stretched || (*stretched<1 + noticeable&& * stretched> 1 / (1 + noticeable))) return;
    diagnostics.add(
        warning(Fault::aspect, {},
                message("the picture is ", ratio_text(static_cast<double>(width) / height),
                        " and the camera's view ", ratio_text(length(seen.right) / length(seen.up)),
                        ": balls become ellipses"))
            .with_help("`right x*image_width/image_height` in the camera, where `up` is `y`"));
}

void review(const Scene& scene, const World& world, Diagnostics& diagnostics) {
    if (!scene.camera_given)
        diagnostics.add(
            warning(Fault::no_camera, {}, "there is no camera: the picture is seen from the origin")
                .with_help("camera { location <0, 2, -10> look_at 0 }"));
    if (const Object* object = Surroundings(scene, world).first())
        diagnostics.add(
            warning(
                Fault::camera_inside, object->span,
                world.facts.has_air
                    ? "the camera is inside of this object, and fog is outside: it is not hollow"
                : world.facts.has_media
                    ? "the camera is inside of this object, which hides media: it is not hollow"
                    : "the camera is inside of this object, and all light is outside")
                .with_help("the word `hollow` in the object shows that this is meant"));
    if (world.provenance.object_count == 0)
        diagnostics.add(warning(Fault::no_object, {}, "there is no object to be seen"));
    else if (dark(world))
        diagnostics.add(
            warning(Fault::no_light, {}, "nothing lights this scene")
                .with_help(std::ranges::any_of(world.appearance.materials, glows_black)
                               ? "`emission` is multiplied by the pigment, which is black where "
                                 "none is given: pigment { rgb 1 } finish { emission 5 }"
                               : "light_source { <10, 20, -10>, rgb 1 }, or "
                                 "pigment { rgb 1 } finish { emission 5 } in an object"));
    const bool meant = world.rules.settings.luminaires_said;
    if (const std::optional<LightIndex> around = meant ? std::nullopt : dome(world)) {
        diagnostics.add(
            warning(
                Fault::glowing_dome,
                world.provenance.light_statements[world.provenance.luminaire_statement(*around)],
                "the emission of this object, which is around the camera, lights the scene")
                .with_help("the word `no_luminaire` in the object stops that; global_settings { "
                           "luminaires emission } accepts it"));
    }
    const auto unused = [](const Material& m) { return lets_light_in(*m.texture); };
    if (!world.rules.settings.subsurface.on &&
        std::ranges::any_of(world.appearance.materials, unused))
        diagnostics.add(warning(Fault::no_effect, {},
                                "`subsurface` of finishes has no effect: global_settings lacks "
                                "it")
                            .with_help("global_settings { subsurface { } }"));
    const PhotonSettings& photons = world.rules.settings.photons;
    if (photons.on && !photons.shoots())
        diagnostics.add(warning(Fault::no_effect, {},
                                "`photons` has no effect without a number of them above 0")
                            .with_help("global_settings { photons { count 20000 } }"));
    if (traits(world.rules.settings.light_sampler).by_transmittance && !world.facts.has_media)
        diagnostics.add(warning(Fault::no_effect, {},
                                "`exponential` of light_bvh has no effect in a scene without "
                                "media"));
    const auto* path_traced = std::get_if<PathTraced>(&world.rules.settings.integrator);
    if (!path_traced) return;
    if (world.rules.settings.radiosity.on)
        diagnostics.add(warning(Fault::no_effect, {},
                                "`radiosity` has no effect with path_traced, which follows all "
                                "light"));
    const auto raised = [](const Material& m) { return reflects_to_a_power(*m.texture); };
    if (std::ranges::any_of(world.appearance.materials, raised))
        diagnostics.add(warning(Fault::no_effect, {},
                                "`exponent` of reflections has no effect with path_traced"));
}

}  // namespace candelabra
