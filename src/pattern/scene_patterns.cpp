// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/scene_patterns.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo ObjectPattern::vocabulary = described<ObjectPattern>([] {
    return schema<ObjectPattern>(
        "object", "Inside of an object or outside of it; the object in braces, the list as well.");
});

const ItemInfo PigmentGrey::vocabulary = described<PigmentGrey>([] {
    return schema<PigmentGrey>("pigment_pattern", "The brightness of a pigment, in braces.");
});

const ItemInfo Average::vocabulary = described<Average>([] {
    return schema<Average>("average", "All entries of a map at once, mixed by their numbers.");
});

}  // namespace candelabra
