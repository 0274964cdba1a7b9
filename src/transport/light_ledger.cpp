// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/light_ledger.h"

#include "world/volumes.h"

#include <utility>

namespace candelabra {

LightLedger empty_ledger(const World& world, bool counted) {
    LightLedger ledger;
    if (counted) ledger.lights.resize(world.provenance.light_statements.size() + 1);
    return ledger;
}

void record_seen(LightLedger& ledger, const World& world, PrimitiveIndex primitive,
                 const Vec3& light) {
    if (ledger.lights.empty() || world.lights.luminaires.empty()) return;
    const LightIndex luminaire = world.lights.luminaire_of[primitive];
    if (luminaire != no_primitive)
        ledger.lights[world.provenance.statement_of_luminaire[luminaire]].seen += light;
}

void record_volume(LightLedger& ledger, const World& world, std::span<const PrimitiveIndex> solids,
                   const Vec3& light) {
    if (ledger.lights.empty()) return;
    if (const GlowingVolume* volume = volume_among(world, solids))
        ledger.lights[volume->statement].seen += light;
}

void take_lights(LightLedger& ledger, FunctionRef<void(std::size_t statement, const Vec3&)> use) {
    for (std::size_t i = 0; i + 1 < ledger.lights.size(); ++i)
        use(i, std::exchange(ledger.lights[i].seen, Vec3(0)));
}

}  // namespace candelabra
