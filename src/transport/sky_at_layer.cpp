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

Rgb SkyAtLayer::from(const Vec3& direction, const Rgb& weight) const {
    ++at_.ledger.shadow;
    return from(direction, weight, {ShadowRay(at_, direction, key_).left_from_sky(), 1});
}

Rgb SkyAtLayer::from(const Vec3& direction, const Rgb& weight, const Left& known) const {
    const Rgb light =
        known.left == Rgb(0) ? known.left : known.left * at_.world.sky_radiance(direction);
    return at_({Lamp::sky(), weight, light, known.rays});
}

}  // namespace candelabra
