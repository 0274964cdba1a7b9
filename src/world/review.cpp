// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/review.h"

#include <algorithm>

namespace {

/// Below this a surface that shows nothing but its ambient colour is too dim to be meant so.
constexpr double noticeable_ambient = 0.3;

double greatest(const Vec3& v) { return std::max({v.x, v.y, v.z}); }

bool shows_itself(const Material& material) {
    return greatest(material.texture->finish.ambient) >= noticeable_ambient;
}

bool dark(const World& world) {
    return world.lights.empty() && world.luminaires.empty() &&
           greatest(world.background.radiance()) <= 0 &&
           std::ranges::none_of(world.materials, shows_itself);
}

}  // namespace

void review(const Scene& scene, const World& world, Diagnostics& diagnostics) {
    if (!scene.camera_given)
        diagnostics.add(
            warning(Fault::no_camera, {}, "there is no camera: the picture is seen from the origin")
                .with_help("camera { location <0, 2, -10> look_at 0 }"));
    if (world.objects == 0)
        diagnostics.add(warning(Fault::no_object, {}, "there is no object to be seen"));
    else if (dark(world))
        diagnostics.add(
            warning(Fault::no_light, {}, "nothing lights this scene")
                .with_help("light_source { <10, 20, -10>, rgb 1 }, or finish { emission 5 } in an "
                           "object"));
}
