// SPDX-License-Identifier: GPL-3.0-or-later
// What is inside a solid.
#pragma once

#include "vocabulary/schema.h"

struct Interior {
    double ior = 1;

    static consteval auto vocabulary();
};

consteval auto Interior::vocabulary() {
    using F = Field<Interior>;
    return schema<Interior>("interior", "What is inside a solid.",
                            F{"ior", &Interior::ior, item, "index of refraction", above(0)});
}
