// SPDX-License-Identifier: GPL-3.0-or-later
#include "light/light.h"

#include "vocabulary/schema.h"

const ItemInfo PointLight::vocabulary = described<PointLight>([] {
    using F = Field<PointLight>;
    return schema<PointLight>(
        "light_source", "A light without size that shines in all directions.",
        F{"location", &PointLight::location, positional, "where it is"},
        maybe(
            as_colour(F{"colour", &PointLight::colour, positional, "its colour, of any strength"})),
        F{"fade_distance", &PointLight::fade_distance, item,
          "distance at which it has its colour, when it fades; 0: never", at_least(0)},
        F{"fade_power", &PointLight::fade_power, item,
          "how fast it fades: 2 is nature's way; 0: it does not", at_least(0)},
        F{"shadowless", &PointLight::shadowless, flag,
          "nothing stops its light; gives no highlights"});
});

double fading(const PointLight& light, double distance) {
    if (light.fade_power <= 0 || light.fade_distance <= 0) return 1;
    return 2 / (1 + std::pow(distance / light.fade_distance, light.fade_power));
}
