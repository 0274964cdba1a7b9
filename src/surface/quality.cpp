// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/quality.h"

#include "surface/texture_map.h"

namespace candelabra {

Handle<Texture> simplified(const Handle<Texture>& texture, int quality) {
    if (quality >= quality_reflection) return texture;
    Handle<Texture> result = texture;
    Texture& made = result.edit();
    if (made.choice) {
        TextureMap map = made.choice->map;
        for (TextureStop& stop : map) stop.texture = simplified(stop.texture, quality);
        made.choice.edit().map = std::move(map);
    }
    made.normal = Bump();
    // With conserve_energy, the reflected light is missing from the transmitted light all the same.
    if (!made.finish.conserve_energy) made.finish.reflection = Reflection();
    made.finish.microfacet.coat = 0;
    const bool quick = made.pigment.quick != nullptr;
    if (quality < quality_pigments && quick)
        made.pigment = Pigment{*made.pigment.quick, nullptr, {}};
    // Without light one layer is shown: the uppermost with a quick colour, or else the last.
    if (quality < quality_light && quick) made.below = nullptr;
    if (made.below) made.below = simplified(made.below, quality);
    return result;
}

}  // namespace candelabra
