// SPDX-License-Identifier: GPL-3.0-or-later
#include "backdrop/sky_sphere.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo SkySphere::vocabulary = described<SkySphere>([] {
    using F = Field<SkySphere>;
    return schema<SkySphere>(
        "sky_sphere",
        {"Pigments by direction, far behind everything: the last one on top.",
         "sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.9, 0.8>] [1 rgb <0.3, 0.5, "
         "0.9>] } } }",
         "sky_sphere { pigment { gradient y color_map { [0 rgb 1] [1 rgb <0.3, 0.5, 0.9>] } } "
         "emission 2 luminaire }"},
        F{"emission", &SkySphere::emission, item, "brightness of all pigments together"},
        F{"luminaire", &SkySphere::luminaire, flag,
          "lights the scene, from the directions where it is bright"});
});

namespace {

Rgb by_old_rules(const SkySphere& sky, const Vec3& direction, const Rgb& background,
                 const PatternScene& scene) {
    Rgb sum(0), tint(1);
    double filter = 1, transmit = 1, passing = 1;
    for (std::size_t i = sky.pigments.size(); i-- > 0;) {
        const Colour colour = evaluate(sky.pigments[i], direction, scene);
        sum += colour.rgb * ((1 - colour.filter - colour.transmit) * passing);
        tint *= colour.rgb;
        filter *= colour.filter;
        transmit *= colour.transmit;
        passing = std::abs(filter) + std::abs(transmit);
    }
    return sum * sky.emission + background * (tint * filter + Rgb(transmit));
}

}  // namespace

Rgb radiance(const SkySphere& sky, const Vec3& direction, const Rgb& background,
             const PatternScene& scene, bool old_rules) {
    if (old_rules) return by_old_rules(sky, direction, background, scene);
    Rgb sum(0), passing(1);
    for (std::size_t i = sky.pigments.size(); i-- > 0;) {
        const Colour colour = evaluate(sky.pigments[i], direction, scene);
        sum += passing * colour.opacity() * colour.rgb * sky.emission;
        passing *= colour.passing();
    }
    return sum + passing * background;
}

}  // namespace candelabra
