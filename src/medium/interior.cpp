// SPDX-License-Identifier: GPL-3.0-or-later
#include "medium/interior.h"

#include "base/elementary.h"
#include "vocabulary/schema.h"

#include <algorithm>

namespace candelabra {

const ItemInfo Interior::vocabulary = described<Interior>([] {
    using F = Field<Interior>;
    return schema<Interior>(
        "interior",
        {"What is inside a solid.", "interior { ior 1.5 }",
         "interior { ior 1.5 fade_distance 1 fade_power 1001 fade_color <0.2, 0.6, 0.3> }",
         "interior { ior 1.5 dispersion 1.02 dispersion_samples 7 caustics 0.5 }",
         "sphere { y, 1 hollow pigment { rgbt 1 } interior { media { emission 0.2 } luminaire } }"},
        F{"ior", &Interior::ior, item, "index of refraction; 0: 1, and no dispersion", at_least(0)},
        F{"fade_distance", &Interior::fade_distance, item,
          "way by which light is dimmed to half; 0: it is not", at_least(0)},
        F{"fade_power", &Interior::fade_power, item,
          "how fast it is dimmed; from 1000 on exponentially, as nature does", at_least(0)},
        F{"fade_color", &Interior::fade_color, item, "colour of light that has gone far"},
        F{"caustics", &Interior::caustics, item,
          "brightens shadows where light passes the surface straight on; 0: not"},
        F{"dispersion", &Interior::dispersion, item,
          "index of refraction at violet over that at red", above(0)},
        F{"dispersion_samples", &Interior::dispersion_samples, item,
          "rays that white light is split into", between(2, 100)},
        F{"luminaire", &Interior::luminaire, flag,
          "what its media emit lights the scene, as a luminaire does"});
});

Interior transformed(Interior interior, const Transform& transform) {
    for (Media& each : interior.media) each = transformed(std::move(each), transform);
    return interior;
}

bool moves(const Interior& interior) {
    return std::ranges::any_of(interior.media, [](const Media& m) { return !m.homogeneous(); });
}

Rgb attenuation(const Interior& interior, double distance) {
    if (std::abs(interior.fade_distance) < 1e-10) return Rgb(1);
    const double way = distance / interior.fade_distance;
    const Rgb& kept = interior.fade_color;
    if (interior.fade_power >= 1000) return math::exp((kept - Rgb(1)) * way);
    return kept + (Rgb(1) - kept) / (1 + math::pow(way, interior.fade_power));
}

}  // namespace candelabra
