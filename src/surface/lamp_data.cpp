// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/lamp_data.h"

#include "photometry/light_colour.h"
#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo LampData::vocabulary = described<LampData>([] {
    using F = Field<LampData>;
    return schema<LampData>(
        "luminaire", "A lamp by its data sheet: how bright it glows follows from its area.",
        F{"flux", &LampData::flux, item,
          "luminous flux that leaves its surface, as lumen(800); without it, that of the file",
          at_least(0)},
        F{"temperature", &LampData::temperature, item,
          "colour temperature of its light in kelvin, 2700 for warm white",
          between(min_planck, max_planck)},
        F{"ies", &LampData::ies, item,
          "file of IES LM-63 with its intensity by direction, and its flux if none is given"},
        F{"ldt", &LampData::ldt, item, "the same of EULUMDAT"},
        F{"lamp_set", &LampData::lamp_set, item, "which set of lamps of EULUMDAT counts",
          between(1, 100)},
        F{"aim", &LampData::aim, item, "where the straight down of the file leads"},
        F{"c0", &LampData::c0, item, "where the plane C0 of the file lies"},
        F{"mirrored", &LampData::mirrored, flag, "the planes C90 and C270 change places"});
});

Vec3 lamp_emission(const LampData& lamp, const Vec3& emission) {
    const Vec3 plain = emission == Vec3(0) ? Vec3(1) : emission;
    return lamp.temperature ? light_luminance(plain) * planck_colour(*lamp.temperature) : plain;
}

}  // namespace candelabra
