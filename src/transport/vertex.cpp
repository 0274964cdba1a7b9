// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/vertex.h"

#include "scattering/real_surface.h"

namespace candelabra {

Vertex vertex_at(const World& world, const Ray& ray, const Hit& hit,
                 std::span<const PrimitiveIndex> around) {
    const auto facing = [&](const Vec3& n) { return dot(n, ray.direction) > 0 ? -n : n; };
    Vertex vertex{hit, {}, &world.material(hit.primitive), around};
    Shading& s = vertex.shading;
    s.position = hit.position;
    s.view = ray.direction;
    s.geometric_normal = facing(hit.normal);
    s.smooth_normal = facing(hit.smooth_normal);
    s.normal = s.smooth_normal;
    s.both_sides = vertex.material->double_illuminate;
    return vertex;
}

Shading with_layer(const World& world, const Vertex& vertex, const Layer& layer) {
    Shading s = vertex.shading;
    s.normal = layer.normal;
    s.finish = layer.finish;
    s.colour = layer.colour;
    s.opacity = world.opacity(layer.colour);
    return s;
}

ShadingRules shading_rules(const World& world) {
    const GlobalSettings& settings = world.rules.settings;
    // The ambient term stands for light between surfaces. Old scenes keep both, as in POV-Ray.
    const bool ambient = !world.facts.has_indirect_light || world.rules.language_version < 3.7;
    return {settings.irid_wavelength, ambient ? settings.ambient_light : Rgb(0),
            world.pattern_scene().noise_generator};
}

bool passes_surfaces(const World& world) {
    return std::holds_alternative<PovRay>(world.rules.settings.integrator);
}

Receiver receiver(const Shading& s) {
    // Facets reflect light from everywhere above the real surface; others, above their own horizon.
    return {s.position, s.finish->microfacet.on ? s.geometric_normal : s.normal,
            answers_behind(s) ? Horizon::both_sides : Horizon::one_side};
}

Receiver receiver(const Scatterer& scatterer) {
    return scatterer.in_air() ? scatterer.phase().receiver() : receiver(scatterer.bsdf().shading());
}

Vertex vertex_in_air(const World& world, const Ray& ray, double distance,
                     std::span<const PrimitiveIndex> around) {
    static const Material air;
    constexpr double relative_tolerance = 1e-9;
    Vertex vertex{{}, {}, around.empty() ? &air : &world.material(around.back()), around};
    vertex.shading.position = ray.at(distance);
    vertex.shading.view = ray.direction;
    vertex.hit.position = vertex.shading.position;
    vertex.hit.tolerance =
        relative_tolerance * (distance + max_component(glm::abs(vertex.shading.position)));
    return vertex;
}

VisibleTextures visible_textures(const World& world, const Vertex& vertex, double least) {
    const Shading& s = vertex.shading;
    const Hit& hit = vertex.hit;
    const SurfaceView view{s.position, s.normal, s.view};
    const Side side = hit.side_towards(s.view);
    SurfaceAxes axes;
    PatternScene scene =
        world.pattern_scene({hit.primitive, hit.part, hit.position, hit.normal, side}, axes);
    scene.view = &view;
    VisibleTextures found;
    world.for_textures(
        hit.primitive, hit.part, hit.position, side,
        [&](double share, const Texture& texture, const Transform* place) {
            if (share < least) return;
            for_layers(
                texture, s.position, s.normal, scene,
                [&](double weight, std::span<const Layer> layers) {
                    found.push_back({share * weight, {layers.begin(), layers.end()}});
                },
                place);
        });
    return found;
}

const VisibleTexture* choose(const VisibleTextures& textures, double u) {
    for (const VisibleTexture& each : textures) {
        if (u < each.weight) return &each;
        u -= each.weight;
    }
    return nullptr;
}

}  // namespace candelabra
