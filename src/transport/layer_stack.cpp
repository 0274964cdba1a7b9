// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/layer_stack.h"

#include "scattering/microfacet.h"
#include "scattering/mirror.h"
#include "surface/quality.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace candelabra {

namespace {

/// Fraction of light that a finish with `conserve_energy` leaves below its mirror.
Rgb below_mirror(const Rgb& reflected) { return clamp(Rgb(1) - reflected, Rgb(0), Rgb(1)); }

/// Fraction of light that a layer transmits to the layers below it: of what its mirror and its
/// facets leave. `ior_ratio` is the index of refraction in front of the surface over the one behind
/// it.
Rgb kept_by(const Shading& s, double ior_ratio) {
    Rgb clear = s.colour.passing();
    if (s.finish->microfacet.on) clear *= Microfacets(s).passing();
    if (!s.finish->conserve_energy) return clear;
    return clear * below_mirror(reflectivity(s, ior_ratio));
}

/// Factor on the diffuse part of a layer, so that it reflects, scatters and transmits no more than
/// all light.
double diffuse_beside(const Shading& s, const Rgb& reflected) {
    const Finish& f = *s.finish;
    const Rgb wanted = s.colour.rgb * s.opacity * (std::fmax(f.diffuse, 0) + f.diffuse_back);
    const Rgb left = (Rgb(1) - reflected) * (Rgb(1) - s.colour.passing());
    double factor = 1;
    for (int i = 0; i < 3; ++i)
        if (wanted[i] > 0) factor = std::fmin(factor, left[i] / wanted[i]);
    return std::fmax(factor, 0);
}

}  // namespace

LayerStack::LayerStack(const World& world, const PathState& path, const Vertex& vertex,
                       const Layers& layers)
    : world_(world),
      vertex_(vertex),
      layers_(layers.data(), layers.size()),
      top_(with_layer(world, vertex, layers.front())) {
    const bool transparent = vertex.material->transparent;
    const bool asks = transparent || std::ranges::any_of(layers, [](const Layer& layer) {
                          return layer.finish->reflection.fresnel;
                      });
    if (asks) interface_ = interface_at(world, path.media, vertex.hit.primitive, path.band);
    if (!transparent) return;
    // Where energy is kept, mirrors and total reflection share the light: the latter takes the
    // place of what would pass, and the mirror has what it has from outside.
    if (world.facts.keeps_energy && candelabra::reflects_totally(top_, interface_.plain))
        interface_.plain = 1 / interface_.plain;
    behind_ = Rgb(1);
    for (const Layer& layer : layers)
        behind_ *= kept_by(with_layer(world, vertex, layer), interface_.plain);
    // A negative share, which subtracts light from behind, counts like a positive one.
    clear_ = std::abs(grey(behind_)) > world.rules.settings.adc_bailout &&
             world.rules.quality >= quality_pigments;
    total_ =
        clear_ && interface_.bands == 0 && candelabra::reflects_totally(top_, interface_.ratio);
}

void LayerStack::visit(FunctionRef<void(const Seen&)> use) const {
    Rgb through(1);
    for (const Layer& layer : layers_) {
        const bool first = &layer == layers_.data();
        Seen seen{first ? top_ : with_layer(world_, vertex_, layer), through,
                  first ? 1 : grey(through), Rgb(0)};
        if (seen.weight <= world_.rules.settings.adc_bailout) return;
        const Finish& finish = *seen.shading.finish;
        const bool conserves = world_.facts.keeps_energy && finish.conserve_energy;
        // Total reflection replaces that of all layers with the normal at which it happens, unless
        // these leave light for it.
        const bool replaced = total_ && !conserves && seen.shading.normal == top_.normal;
        if (!replaced && world_.rules.quality >= quality_reflection)
            seen.reflected = reflectivity(seen.shading, interface_.plain);
        if (conserves && finish.microfacet.on)
            seen.below_mirror = below_mirror(seen.reflected);
        else if (conserves)
            seen.diffuse = diffuse_beside(seen.shading, seen.reflected);
        if (conserves) seen.reflected *= through;
        use(seen);
        through *= kept_by(seen.shading, interface_.plain);
    }
}

StraightWay::StraightWay(const World& world, const Ray& ray, bool bent)
    : world_(world), ray_(ray), bent_(bent) {}

Rgb StraightWay::passed(const Hit& hit, std::span<const PrimitiveIndex> solids) {
    const Material& material = world_.material(hit.primitive);
    const bool focuses = material.interior && material.interior->caustics != 0;
    if (!world_.facts.keeps_energy || !material.keeps_energy || material.no_shadow || focuses)
        return world_.passed(hit, ray_);
    return seen(hit, solids);
}

Rgb StraightWay::seen(const Hit& hit, std::span<const PrimitiveIndex> solids) {
    if (!world_.material(hit.primitive).transparent) return Rgb(0);
    return seen(hit, solids,
                interface_at(world_, MediaStack(solids.begin(), solids.end()), hit.primitive,
                             std::nullopt));
}

Rgb StraightWay::seen(const Hit& hit, std::span<const PrimitiveIndex> solids,
                      const Interface& surface) {
    const Vertex vertex = vertex_at(world_, ray_, hit, solids);
    const bool real = !std::exchange(bent_, bent_ || surface.ratio != 1);
    const double from_outside = std::min(surface.plain, 1 / surface.plain);
    const auto met = [&](Shading s) {
        if (!real && s.finish->microfacet.on && surface.plain > 1)
            s.view = refracted_direction(s, from_outside);
        return s;
    };
    Rgb sum(0);
    for (const auto& [weight, layers] : visible_textures(world_, vertex)) {
        const Shading top = with_layer(world_, vertex, layers.front());
        Rgb left(weight * top.finish->refraction);
        // Total reflection takes the place of what passes.
        const bool at_angle = real && !reflects_totally(top, surface.plain);
        for (const Layer& layer : layers)
            left *= kept_by(met(with_layer(world_, vertex, layer)),
                            at_angle ? surface.plain : from_outside);
        sum += left;
    }
    return sum;
}

Rgb left_inside(const World& world, const PathState& path, const Hit& hit) {
    const auto& interior = world.material(hit.primitive).interior;
    if (!interior || interior->fade_distance == 0 || !is_in(world, path.media, hit.primitive))
        return Rgb(1);
    return attenuation(*interior, length(hit.position - path.ray.origin));
}

}  // namespace candelabra
