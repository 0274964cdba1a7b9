// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/scene_patterns.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo ObjectPattern::vocabulary = described<ObjectPattern>([] {
    return schema<ObjectPattern>(
        "object",
        {"Inside of an object or outside of it; the object in braces, the list as well.",
         "pigment { object { torus { 0.8, 0.3 rotate 90*x } rgb 0.2, rgb <0.9, 0.6, 0.3> } }"});
});

const ItemInfo PigmentGrey::vocabulary = described<PigmentGrey>([] {
    return schema<PigmentGrey>("pigment_pattern",
                               {"The brightness of a pigment, in braces.",
                                "pigment { pigment_pattern { checker rgb 0.2, rgb 0.8 scale 0.3 } "
                                "color_map { [0 rgb <0.2, 0.4, 0.8>] [1 rgb 1] } }"});
});

const ItemInfo Average::vocabulary = described<Average>([] {
    return schema<Average>(
        "average",
        {"All entries of a map at once, mixed by their numbers.",
         "pigment { average pigment_map { [1 gradient x scale 0.4] [1 gradient y scale 0.4] } }"});
});

}  // namespace candelabra
