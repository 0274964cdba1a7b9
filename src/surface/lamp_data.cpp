// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/lamp_data.h"

#include "photometry/light_colour.h"
#include "photometry/web_fields.h"
#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo LampData::vocabulary = described<LampData>([] {
    using F = Field<LampData>;
    using Web = WebFields<LampData>;
    return schema<LampData>(
        "luminaire",
        {"A lamp by its data sheet: how bright it glows follows from its area.",
         "sphere { y, 0.2 luminaire { flux 800 temperature 2700 } }",
         "sphere { y, 0.2 luminaire { ies \"gems.gltf\" profile 0 multiplier 0.02 } }"},
        F{"flux", &LampData::flux, item,
          "luminous flux that leaves its surface, as lumen(800); without it, that of the file",
          at_least(0)},
        F{"temperature", &LampData::temperature, item,
          "colour temperature of its light in kelvin, 2700 for warm white",
          between(min_planck, max_planck)},
        Web::ies, Web::ldt, Web::profile, Web::lamp_set, Web::multiplier, Web::aim, Web::c0,
        Web::mirrored);
});

Rgb lamp_emission(const LampData& lamp, const Rgb& emission) {
    const Rgb plain = emission == Rgb(0) ? Rgb(1) : emission;
    return lamp.temperature ? light_luminance(plain) * planck_colour(*lamp.temperature) : plain;
}

}  // namespace candelabra
