// SPDX-License-Identifier: GPL-3.0-or-later
// What `model { }` says of a file with objects. The reader of objects replaces it by the objects.
#pragma once

#include "vocabulary/item_info.h"

#include <string>

namespace candelabra {

struct ModelSettings {
    std::string file;
    std::string part;

    static const ItemInfo vocabulary;
};

}  // namespace candelabra
