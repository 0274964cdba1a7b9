// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/luminaire_list.h"

#include "luminaire/placed.h"
#include "world/prototype.h"

#include <algorithm>

namespace candelabra {

LightIndex LuminaireList::add(PrimitiveIndex first_primitive, const Prototype& prototype,
                              const Transform& place) {
    const auto first = static_cast<LightIndex>(size());
    placed_.push_back({first, first_primitive, &prototype, &place});
    placed_count_ += prototype.luminaires.size();
    return first;
}

Luminaire LuminaireList::made(LightIndex light) const {
    const PlacedLuminaires& among =
        *(std::ranges::upper_bound(placed_, light, {}, &PlacedLuminaires::first) - 1);
    Luminaire result =
        candelabra::placed(among.prototype->luminaires[light - among.first], *among.place);
    result.primitive += among.primitive;
    return result;
}

}  // namespace candelabra
