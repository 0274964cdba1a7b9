// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/interior.h"

#include "vocabulary/schema.h"

const ItemInfo Interior::vocabulary = described<Interior>([] {
    using F = Field<Interior>;
    return schema<Interior>("interior", "What is inside a solid.",
                            F{"ior", &Interior::ior, item, "index of refraction", above(0)});
});
