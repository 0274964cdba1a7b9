// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/light_units.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo PhotometricUnits::vocabulary = described<PhotometricUnits>([] {
    using F = Field<PhotometricUnits>;
    return schema<PhotometricUnits>(
        "photometry",
        {"What the numbers of the scene are in metres and in candela.",
         "global_settings { photometry { unit 1 white 1000 } }"},
        F{"unit", &PhotometricUnits::unit, item,
          "how many metres a unit of the scene is; without it, mm_per_unit / 1000", above(0)},
        F{"white", &PhotometricUnits::white, item,
          "luminance in cd/m2 that a radiance of 1 stands for", above(0)});
});

}  // namespace candelabra
