// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/light_path.h"

#include "base/cosine_direction.h"
#include "scattering/bsdf.h"
#include "surface/lambertian.h"
#include "transport/light_left.h"
#include "transport/path_steps.h"
#include "transport/sight.h"
#include "transport/subsurface.h"

#include <algorithm>
#include <numbers>

namespace candelabra {

namespace {

/// Minimum survival probability of a light path at a surface that reflects next to nothing.
constexpr double min_light_survival = 0.05;
/// Minimum cosine of incidence. Light below it is invisible, and would lead to a division by zero.
constexpr double grazing_cosine = 1e-6;

/// The way of light that has come to the vertex from a point, as a shadow ray goes it.
WayOfLight way_back(const Vertex& vertex, const Vec3& from) {
    return {.ray = {vertex.position(), -vertex.shading.view},
            .tolerance = vertex.tolerance(),
            .distance = length(vertex.position() - from),
            .around = vertex.around};
}

}  // namespace

bool is_even_on_each_side(const World& world, const Vertex& vertex, const Shading& s) {
    return is_even_on_each_side(*s.finish) && !vertex.material->by_view && !s.both_sides &&
           !scatters_inside(world, s);
}

bool is_lambertian(const World& world, const Vertex& vertex, const Shading& s) {
    return is_even_on_each_side(world, vertex, s) && is_lambertian(*s.finish);
}

LightPaths::LightPaths(const Shot& shot, int max_reflections)
    : shot_(shot),
      world_(*shot.world),
      rules_(shading_rules(world_)),
      lamp_rays_(world_),
      max_reflections_(max_reflections) {}

/// A light path that has arrived at a vertex.
struct LightPaths::Lit {
    PathState path;
    Vertex vertex;
    Vec3 power;  ///< colour of light times area perpendicular to the ray
    int reflections = 0;
    Lamp lamp = Lamp::sky();
};

void LightPaths::follow(const Key& key, double share,
                        std::vector<ReflectedLuminaire>& found) const {
    auto drawn = lamp_rays_.draw(
        key, share, [&](const Luminaire& luminaire) { return shot_.inner_rays(luminaire); });
    if (!drawn) return;
    const LightIndex light = drawn->light;
    const Luminaire& luminaire = world_.lights.luminaires[light];
    PathState& path = drawn->path;
    const Vec3 begin = path.ray.origin;
    // Attenuates light to each surface on the way as a shadow ray from that surface would.
    for (int met = 0; met < max_surfaces_along; ++met) {
        path.key = key.branched(Branch::light_path, static_cast<std::uint32_t>(met));
        Hit hit;
        if (!world_.first_hit(path.ray, path.tolerance, path.kind, hit)) return;
        const Vertex vertex =
            vertex_at(world_, path.ray, hit, {path.media.data(), path.media.size()});
        const WayOfLight way = way_back(vertex, begin);
        const Vec3 left = light_left(world_, way, path.key);
        if (left != Vec3(0)) {
            const Vec3 seen =
                radiance_seen(world_, {luminaire, way.ray, way.tolerance, way.distance});
            if (seen == Vec3(0)) return;
            const Vec3 by_lamp = left_by_lamp(world_, luminaire, way, path.key);
            go_on({path, vertex, drawn->power_of_one * left * by_lamp * seen, 0,
                   Lamp::luminaire(light)},
                  found);
        }
        if (world_.passed(hit, path.ray) == Vec3(0)) return;
        path.media = interface_at(world_, path.media, hit.primitive, path.band).behind;
        path.ray.origin = vertex.position();
        path.tolerance = vertex.tolerance();
    }
}

/// Radiance that the even layers show on the side of the vertex, equal in all directions, for light
/// of colour 1 that arrives along the path's ray.
Vec3 LightPaths::reflected(const PathState& path, const Vertex& vertex) const {
    Vec3 sum(0);
    for (const VisibleTexture& each : visible_textures(world_, vertex))
        LayerStack(world_, path, vertex, each.layers).visit([&](const LayerStack::Seen& layer) {
            if (!is_even_on_each_side(world_, vertex, layer.shading)) return;
            sum += each.weight * layer.through *
                   Bsdf(layer.shading, rules_).evaluate(-path.ray.direction, diffuse_terms, 0);
        });
    return sum;
}

/// The place of a vertex as it is seen from the other side.
Vertex LightPaths::other_side(const PathState& path, const Vertex& vertex) const {
    const Ray back{vertex.position() + path.ray.direction, -path.ray.direction};
    return vertex_at(world_, back, vertex.hit, vertex.around);
}

/// Follows the path from surface to surface as long as they reflect it.
void LightPaths::go_on(Lit lit, std::vector<ReflectedLuminaire>& found) const {
    while (++lit.reflections <= max_reflections_) {
        const Vec3 normal = lit.vertex.shading.geometric_normal;
        const double cosine = -dot(lit.path.ray.direction, normal);
        if (cosine < grazing_cosine) return;
        const auto leave = [&](const Vertex& seen) {
            const Vec3 power = lit.power * reflected(lit.path, seen) / cosine;
            if (power != Vec3(0))
                found.push_back({seen.position(), seen.shading.geometric_normal, power,
                                 seen.tolerance(), lit.reflections, lit.lamp});
            return power;
        };
        const Vec3 front = leave(lit.vertex);
        const Vec3 back = lit.vertex.material->lit_from_behind
                              ? leave(other_side(lit.path, lit.vertex))
                              : Vec3(0);
        const double in_front = max_component(glm::abs(front)),
                     behind = max_component(glm::abs(back)), all = in_front + behind;
        if (all == 0) return;
        const double survival =
            std::clamp(all / max_component(glm::abs(lit.power)), min_light_survival, 1.0);
        if (uniform(lit.path.key, Purpose::roulette) >= survival) return;
        const bool passes = uniform(lit.path.key, Purpose::way_choice) * all < behind;
        lit.power = (passes ? back : front) / (survival * ((passes ? behind : in_front) / all));
        const Vec2 u{uniform(lit.path.key, Purpose::bounce_u),
                     uniform(lit.path.key, Purpose::bounce_v)};
        lit.path = passes ? gathering_path_behind(world_, lit.path, lit.vertex,
                                                  cosine_direction(-normal, u))
                          : gathering_path(lit.path, lit.vertex, cosine_direction(normal, u));
        Hit hit;
        if (!world_.first_hit(lit.path.ray, lit.path.tolerance, lit.path.kind, hit)) return;
        const Vec3 from = lit.path.ray.origin;
        lit.vertex =
            vertex_at(world_, lit.path.ray, hit, {lit.path.media.data(), lit.path.media.size()});
        if (!world_.facts.dims_between) continue;
        lit.power *= light_left(world_, way_back(lit.vertex, from), lit.path.key);
        if (lit.power == Vec3(0)) return;
    }
}

}  // namespace candelabra
