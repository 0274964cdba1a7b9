// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/review.h"

#include "solid/extent.h"
#include "solid/solid.h"

#include <algorithm>

namespace {

/// Below this a surface that shows nothing but its ambient colour is too dim to be meant so.
constexpr double noticeable_ambient = 0.3;

double greatest(const Vec3& v) { return std::max({v.x, v.y, v.z}); }

bool shows_itself(const Material& material) {
    const Texture& texture = *material.texture;
    return texture.choice || texture.below ||
           greatest(texture.finish.ambient) >= noticeable_ambient;
}

bool dark(const World& world) {
    return world.lights.empty() && world.luminaires.empty() && !world.sky &&
           greatest(world.background.radiance()) <= 0 &&
           std::ranges::none_of(world.materials, shows_itself);
}

/// The first solid object around the point that does not say `hollow`. Null: none.
const Object* around(const Scene& scene, const Vec3& point) {
    Solids solids;
    for (const ObjectHandle& object : scene.objects) {
        const auto* shape = std::get_if<Shape>(&object->form);
        const auto* sphere = shape ? std::get_if<Sphere>(shape) : nullptr;
        const bool apart = sphere && !object->transform && !object->inverse
                               ? length(point - sphere->centre) >= sphere->radius
                               : !object->inverse && !contains(extent(*object), point);
        if (apart || object->hollow || object->no_image || !has_inside(*object)) continue;
        if (solids.inside(object, point)) return object.get();
    }
    return nullptr;
}

}  // namespace

void review(const Scene& scene, const World& world, Diagnostics& diagnostics) {
    if (!scene.camera_given)
        diagnostics.add(
            warning(Fault::no_camera, {}, "there is no camera: the picture is seen from the origin")
                .with_help("camera { location <0, 2, -10> look_at 0 }"));
    if (const Object* object = around(scene, world.camera.location))
        diagnostics.add(warning(Fault::camera_inside, object->span,
                                "the camera is inside of this object, which is not hollow")
                            .with_help("the word `hollow` in the object says that this is meant"));
    if (world.objects == 0)
        diagnostics.add(warning(Fault::no_object, {}, "there is no object to be seen"));
    else if (dark(world))
        diagnostics.add(
            warning(Fault::no_light, {}, "nothing lights this scene")
                .with_help("light_source { <10, 20, -10>, rgb 1 }, or finish { emission 5 } in an "
                           "object"));
}
