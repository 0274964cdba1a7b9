// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/sky_at_layer.h"

namespace candelabra {

std::optional<Vec3> SkyAtLayer::draw() const {
    const double u = uniform(key_, Purpose::sky_choice);
    const Vec2 place{uniform(key_, Purpose::sky_u), uniform(key_, Purpose::sky_v)};
    return u < 0.5 ? std::optional(at_.world.sky.light.draw(place).direction)
                   : at_.layer.scatterer.sample(place);
}

double SkyAtLayer::density(const Vec3& direction) const {
    return 0.5 * (at_.world.sky.light.density(direction) + at_.layer.scatterer.pdf(direction));
}

Vec3 SkyAtLayer::from(const Vec3& direction, const Vec3& weight) const {
    ++at_.ledger.shadow;
    return from(direction, weight, {ShadowRay(at_, direction, key_).left_from_sky(), 1});
}

Vec3 SkyAtLayer::from(const Vec3& direction, const Vec3& weight, const Left& known) const {
    const Vec3 light =
        known.left == Vec3(0) ? known.left : known.left * at_.world.sky_radiance(direction);
    return at_({Lamp::sky(), weight, light, known.rays});
}

}  // namespace candelabra
