// SPDX-License-Identifier: GPL-3.0-or-later
// What is inside a solid.
#pragma once

#include "vocabulary/item_info.h"

struct Interior {
    double ior = 1;

    static const ItemInfo vocabulary;
};
