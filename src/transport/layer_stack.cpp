// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/layer_stack.h"

#include "scattering/mirror.h"
#include "surface/quality.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

/// Fraction of light that a layer transmits to the layers below it. `ior_ratio` is the index of
/// refraction in front of the surface over the one behind it.
Vec3 kept_by(const Shading& s, double ior_ratio) {
    const Vec3 clear = s.colour.passing();
    if (!s.finish->conserve_energy) return clear;
    return clear * glm::clamp(Vec3(1) - reflectivity(s, ior_ratio), Vec3(0), Vec3(1));
}

/// Factor on the diffuse part of a layer, so that it reflects, scatters and transmits no more than
/// all light.
double diffuse_beside(const Shading& s, const Vec3& reflected) {
    const Finish& f = *s.finish;
    const Vec3 wanted = s.colour.rgb * s.opacity * (std::fmax(f.diffuse, 0) + f.diffuse_back);
    const Vec3 left = (Vec3(1) - reflected) * (Vec3(1) - s.colour.passing());
    double factor = 1;
    for (int i = 0; i < 3; ++i)
        if (wanted[i] > 0) factor = std::fmin(factor, left[i] / wanted[i]);
    return std::fmax(factor, 0);
}

}  // namespace

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
    for (const Layer& layer : layers)
        behind_ *= kept_by(with_layer(world, vertex, layer), interface_.plain);
    // A negative share, which subtracts light from behind, counts like a positive one.
    clear_ = std::abs(grey(behind_)) > world.rules.settings.adc_bailout &&
             world.rules.quality >= quality_pigments;
    total_ =
        clear_ && interface_.bands == 0 && candelabra::reflects_totally(top_, interface_.ratio);
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
        const Finish& finish = *seen.shading.finish;
        if (world_.keeps_energy() && finish.conserve_energy && !finish.microfacet.on)
            seen.diffuse = diffuse_beside(seen.shading, seen.reflected);
        use(seen);
        through *= kept_by(seen.shading, interface_.plain);
    }
}

Vec3 passed_straight(const World& world, const Ray& ray, const Hit& hit,
                     std::span<const PrimitiveIndex> solids) {
    const Material& material = world.material(hit.primitive);
    const bool focuses = material.interior && material.interior->caustics != 0;
    if (!world.keeps_energy() || !material.keeps_energy || material.no_shadow || focuses)
        return world.passed(hit, ray);
    const Vertex vertex = vertex_at(world, ray, hit, solids);
    const MediaStack around(solids.begin(), solids.end());
    const double plain = interface_at(world, around, hit.primitive, std::nullopt).plain;
    const double from_outside = std::min(plain, 1 / plain);
    Vec3 sum(0);
    for_visible_layers(world, vertex, 0, [&](double weight, std::span<const Layer> layers) {
        Vec3 left(weight * layers.front().finish->refraction);
        for (const Layer& layer : layers)
            left *= kept_by(with_layer(world, vertex, layer), from_outside);
        sum += left;
    });
    return sum;
}

Vec3 left_inside(const World& world, const PathState& path, const Hit& hit) {
    const auto& interior = world.material(hit.primitive).interior;
    if (!interior || interior->fade_distance == 0 || !is_in(world, path.media, hit.primitive))
        return Vec3(1);
    return attenuation(*interior, length(hit.position - path.ray.origin));
}

}  // namespace candelabra
