// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/aovs.h"

#include "transport/integrator.h"

namespace candelabra {

namespace {

/// Adds a colour or a direction.
template <class Triple>
void add(std::span<ExactSum> sums, std::size_t first, const Triple& value) {
    for (int i = 0; i < 3; ++i) sums[first + static_cast<std::size_t>(i)].add(value[i]);
}

}  // namespace

void gather_sample(const Aovs& wanted, const World& world, const Ray& ray, Integrator& integrator,
                   std::span<ExactSum> sums) {
    const PrimaryHit seen = wanted.surface ? primary_hit(world, ray) : PrimaryHit();
    if (wanted.alpha) sums[0].add(integrator.clear());
    if (wanted.lights)
        take_lights(integrator.ledger(), [&](std::size_t statement, const Rgb& light) {
            const std::size_t first = wanted.first_light() + 3 * statement;
            // A later moment of the scene may have more statements than the first one.
            if (first + 3 <= sums.size() && light != Rgb(0)) add(sums, first, light);
        });
    if (wanted.squares) add(sums, wanted.first_glow(), integrator.ledger().glow);
    if (!seen.met) return;
    add(sums, wanted.albedo(), seen.albedo);
    add(sums, wanted.normal(), seen.normal);
}

PrimaryHit seen_at_middle(const Aovs& wanted, const Shot& shot, const PicturePoint& at) {
    return wanted.surface ? primary_hit(*shot.world, middle_ray(shot, at)) : PrimaryHit();
}

void gather_middle(const Aovs& wanted, const PrimaryHit& seen, std::span<ExactSum> sums) {
    if (!wanted.surface) return;
    sums[wanted.depth()].add(seen.distance);
    sums[wanted.object()].add(seen.object);
}

}  // namespace candelabra
