// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/layer_stack.h"

#include "scattering/mirror.h"
#include "surface/quality.h"

#include <algorithm>

namespace candelabra {

LayerStack::LayerStack(const World& world, const PathState& path, const Vertex& vertex,
                       std::span<const Layer> layers)
    : world_(world),
      vertex_(vertex),
      layers_(layers),
      top_(with_layer(world, vertex, layers.front())) {
    const bool transparent = vertex.material->transparent;
    const bool asks = transparent || std::ranges::any_of(layers, [](const Layer& layer) {
                          return layer.finish->reflection.fresnel;
                      });
    if (asks) interface_ = interface_at(world, path.media, vertex.hit.primitive, path.band);
    if (!transparent) return;
    behind_ = Vec3(1);
    for (const Layer& layer : layers) behind_ *= kept(with_layer(world, vertex, layer));
    // A negative share, which subtracts light from behind, counts like a positive one.
    clear_ = std::abs(grey(behind_)) > world.rules.settings.adc_bailout &&
             world.rules.quality >= quality_pigments;
    total_ =
        clear_ && interface_.bands == 0 && candelabra::reflects_totally(top_, interface_.ratio);
}

/// Fraction of light that a layer transmits to the layers below it.
Vec3 LayerStack::kept(const Shading& s) const {
    const Vec3 clear = s.colour.passing();
    if (!s.finish->conserve_energy) return clear;
    return clear * glm::clamp(Vec3(1) - reflectivity(s, interface_.plain), Vec3(0), Vec3(1));
}

void LayerStack::visit(FunctionRef<void(const Seen&)> use) const {
    Vec3 through(1);
    for (const Layer& layer : layers_) {
        const bool first = &layer == layers_.data();
        Seen seen{first ? top_ : with_layer(world_, vertex_, layer), through,
                  first ? 1 : grey(through), Vec3(0)};
        if (seen.weight <= world_.rules.settings.adc_bailout) return;
        // Total reflection replaces that of all layers with the normal at which it happens.
        const bool replaced = total_ && seen.shading.normal == top_.normal;
        if (!replaced && world_.rules.quality >= quality_reflection)
            seen.reflected = reflectivity(seen.shading, interface_.plain);
        use(seen);
        through *= kept(seen.shading);
    }
}

Vec3 left_inside(const World& world, const PathState& path, const Hit& hit) {
    const auto& interior = world.material(hit.primitive).interior;
    if (!interior || interior->fade_distance == 0 || !is_in(world, path.media, hit.primitive))
        return Vec3(1);
    return attenuation(*interior, length(hit.position - path.ray.origin));
}

}  // namespace candelabra
