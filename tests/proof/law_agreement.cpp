// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/items.h"
#include "proof/laws.h"

namespace candelabra::proof {

Claims any_strategy(const Script& script, Dice& dice) {
    std::vector<std::string> others = {"light_bvh mis", "light_octree alone", "light_octree paper",
                                       "light_octree max_depth 20"};
    for (const ItemInfo* info : items_of("Light samplers"))
        if (info->name != "light_octree") others.push_back(std::string(info->name));
    const std::string other = dice.pick(others);
    return {same_mean("light_octree = " + other,
                      picture(with_setting(script, "light_sampler", "light_octree")),
                      picture(with_setting(script, "light_sampler", other)))};
}

Claims any_index(const Script& script, Dice&) {
    Claims claims;
    const auto indices = items_of("Indexes");
    const std::string first(indices.front()->name);
    for (const ItemInfo* info : indices.subspan(1)) {
        const std::string other(info->name);
        claims.push_back(same_bytes(first + " = " + other,
                                    picture(with_setting(script, "index", first)),
                                    picture(with_setting(script, "index", other))));
    }
    return claims;
}

}  // namespace candelabra::proof
