// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/media_stack.h"

#include "base/elementary.h"

#include <algorithm>

namespace candelabra {

const Interior& innermost(const World& world, const MediaStack& media) {
    static const Interior atmosphere{.ior = 1};
    if (media.empty()) return atmosphere;
    const auto& inside = world.material(media.back()).interior;
    return inside ? *inside : atmosphere;
}

bool in_atmosphere(const World& world, std::span<const PrimitiveIndex> solids) {
    return std::ranges::all_of(solids,
                               [&](PrimitiveIndex solid) { return world.material(solid).hollow; });
}

bool is_in(const World& world, const MediaStack& media, PrimitiveIndex primitive) {
    const std::uint32_t solid = world.solid(primitive);
    return std::ranges::any_of(media,
                               [&](PrimitiveIndex around) { return world.solid(around) == solid; });
}

Interface interface_at(const World& world, const MediaStack& media, PrimitiveIndex primitive,
                       const std::optional<SpectralBand>& band) {
    Interface result{.behind = media};
    MediaStack& behind = result.behind;
    const Passing passing = world.pass(primitive, behind);
    // Leaving the outer one of two overlapping solids refracts nothing.
    if (passing == Passing::leaves_outer) return result;
    const Interior &here = innermost(world, media), &there = innermost(world, behind);
    result.ratio = here.ior / there.ior;
    // A ray that leaves one solid for another one sees no `fresnel` reflection in POV-Ray 3.7.
    result.plain = passing != Passing::enters && !behind.empty() ? 1 : result.ratio;
    result.dispersion = here.dispersion / there.dispersion;
    if (result.dispersion == 1) return result;
    if (band)
        result.ratio *= math::pow(result.dispersion, band->power());
    else
        result.bands = (here.dispersion != 1 ? here : there).dispersion_samples;
    return result;
}

}  // namespace candelabra
