// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/air_to_camera.h"

#include "base/elementary.h"
#include "medium/media.h"
#include "transport/light_left.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

AirToCamera::AirToCamera(const Shot& shot, const LitRegion& region) {
    const World& world = *shot.world;
    MediaList air;
    for (const Media& media : world.sky.media)
        if (media.homogeneous()) air.push_back(&media);
    if (air.empty()) return;
    const Rgb rate = coefficients(view_of(air), Vec3(0), world.pattern_scene()).extinction;
    extinction_ = std::min({rate.r, rate.g, rate.b});
    const Projection& camera = shot.view.camera;
    centre_ = camera.parallel ? region.centre : camera.location;
    radius_ = camera.parallel ? region.radius : 0;
}

double AirToCamera::transmittance(const Vec3& place) const {
    if (!(extinction_ > 0)) return 1;
    return math::exp(-extinction_ * std::fmax(length(place - centre_) - radius_, 0));
}

}  // namespace candelabra
