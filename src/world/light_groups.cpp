// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/light_groups.h"

#include "world/world.h"

namespace candelabra {

// As in POV-Ray, the outermost group determines whether global lights light its objects. A nested
// group has its own lights instead of those around it, or both if it has a declared name.
bool opens_group(std::vector<LightGroup>& groups, const Union& group, Inherited& here) {
    const bool named = group.named || here.named_group;
    here.named_group = group.named && !group.light_group;
    const std::uint32_t outer = here.light_group;
    if (!group.light_group || (outer != 0 && group.lights.empty())) return false;
    here.light_group = static_cast<std::uint32_t>(groups.size());
    groups.push_back(
        {named ? outer : 0, outer == 0 ? group.global_lights : groups[outer].global_lights});
    return true;
}

bool World::reaches(std::uint32_t light_group, const Material& lit) const {
    if (light_group == 0) return lights.groups[lit.light_group].global_lights;
    return light_group == lit.light_group || light_group == lights.groups[lit.light_group].outer;
}

}  // namespace candelabra
