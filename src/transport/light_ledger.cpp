// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/light_ledger.h"

#include "world/volumes.h"

#include <utility>

namespace candelabra {

void LightLedger::add_reflected(Lamp lamp, const Rgb& radiance, const Rgb& throughput,
                                std::uint64_t rays) {
    if (!provenance) return;
    LightCount& own = lights[provenance->statement_of(lamp)];
    own.light.add(grey(radiance));
    own.seen += throughput * radiance;
    own.rays += rays;
    if (keeps_parts) parts.push_back({lamp, throughput * radiance, false});
}

void LightLedger::add_visible(Lamp lamp, const Rgb& light) {
    if (!provenance) return;
    lights[provenance->statement_of(lamp)].seen += light;
    if (keeps_parts) parts.push_back({lamp, light, true});
}

void LightLedger::add_miss() {
    if (provenance) ++lights.back().rays;
}

LightLedger& LightLedger::operator+=(const LightLedger& other) {
    camera += other.camera;
    shadow += other.shadow;
    scattered += other.scattered;
    noise += other.noise;
    if (lights.size() < other.lights.size()) lights.resize(other.lights.size());
    for (std::size_t i = 0; i < other.lights.size(); ++i) {
        lights[i].light.add(other.lights[i].light);
        lights[i].rays += other.lights[i].rays;
    }
    return *this;
}

LightLedger empty_ledger(const World& world, bool counted, bool parts) {
    LightLedger ledger;
    if (!counted && !parts) return ledger;
    ledger.keeps_parts = parts;
    ledger.lights.resize(world.provenance.light_statements.size() + 1);
    ledger.provenance = &world.provenance;
    return ledger;
}

void record_seen(LightLedger& ledger, const World& world, PrimitiveIndex primitive,
                 const Rgb& light) {
    if (!ledger.provenance || world.lights.luminaires.empty() || primitive == no_primitive) return;
    const LightIndex luminaire = world.luminaire_of(primitive);
    if (luminaire != no_primitive) ledger.add_visible(Lamp::luminaire(luminaire), light);
}

void record_volume(LightLedger& ledger, const World& world, std::span<const PrimitiveIndex> solids,
                   const Rgb& light) {
    if (!ledger.provenance) return;
    if (const GlowingVolume* volume = volume_among(world, solids))
        ledger.add_visible(Lamp::luminaire(volume->box), light);
}

void take_lights(LightLedger& ledger, FunctionRef<void(std::size_t statement, const Rgb&)> use) {
    for (std::size_t i = 0; i + 1 < ledger.lights.size(); ++i)
        use(i, std::exchange(ledger.lights[i].seen, Rgb(0)));
}

}  // namespace candelabra
