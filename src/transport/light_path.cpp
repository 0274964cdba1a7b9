// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/light_path.h"

#include "base/cosine_direction.h"
#include "lighting/draw.h"
#include "scattering/bsdf.h"
#include "surface/lambertian.h"
#include "transport/light_left.h"
#include "transport/path_steps.h"
#include "transport/sight.h"
#include "transport/source_light.h"
#include "transport/subsurface.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace candelabra {

namespace {

/// Minimum survival probability of a light path at a surface that reflects next to nothing.
constexpr double min_light_survival = 0.05;
/// Minimum cosine of incidence. Light below it is invisible, and would lead to a division by zero.
constexpr double grazing_cosine = 1e-6;
/// Distance from what is seen within which reflected light is worth little more, as a fraction of
/// the lit region's radius.
constexpr double close_to_seen = 0.2;

double square(double x) { return x * x; }

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
    : LightPaths(shot, max_reflections, seen_places(shot)) {}

LightPaths::LightPaths(const Shot& shot, int max_reflections, std::vector<SeenPlace> seen)
    : shot_(shot),
      world_(*shot.world),
      rules_(shading_rules(world_)),
      seen_(std::move(seen)),
      region_(LitRegion::of(shot, seen_)),
      lamp_rays_(world_),
      source_rays_(world_.lights.sources, region_),
      sky_rays_(world_, region_),
      power_(lamp_rays_.power() + source_rays_.power() + sky_rays_.power()),
      max_reflections_(max_reflections) {
    if (!seen_.empty()) learn();
}

/// Finds which starts of paths bring light to what is seen.
void LightPaths::learn() {
    const double near = square(close_to_seen * region_.radius);
    const auto worth = [&](const Found& found, const Key& key) {
        double sum = 0;
        std::uint32_t number = 0;
        for (const ReflectedLuminaire& each : found) {
            const Key own = key.branched(Branch::reflected, number++);
            const auto places = static_cast<double>(seen_.size());
            const SeenPlace& place =
                seen_[static_cast<std::size_t>(uniform(own, Purpose::seen_place) * places)];
            if (!sees(world_, place, each.position, each.normal, each.tolerance)) continue;
            const Vec3 offset = each.position - place.position;
            const double away2 = dot(offset, offset);
            const double cosines = dot(offset, place.normal) * -dot(offset, each.normal) / away2;
            sum += luminance(abs(each.power)) * cosines / (away2 + near);
        }
        return sum;
    };
    Found found;
    source_rays_.learn([&](const SourceRays::Drawn& drawn, const Key& key) {
        found.clear();
        from_source(drawn, key, 1, found);
        return worth(found, key);
    });
    if (!(sky_rays_.power() > 0)) return;
    sky_rays_.learn([&](const SkyRays::Drawn& drawn, const Key& key) {
        found.clear();
        from_sky(drawn, key, 1, found);
        return worth(found, key);
    });
}

/// A light path that has arrived at a vertex.
struct LightPaths::Lit {
    PathState path;
    Vertex vertex;
    Rgb power;  ///< colour of light times area perpendicular to the ray
    int reflections = 0;
    Lamp lamp = Lamp::sky();
    Rgb front = Rgb(0);  ///< radiance, on the side of the ray, times area
    Rgb back = Rgb(0);   ///< the same on the other side
};

void LightPaths::follow(const Key& key, double share, Found& found) const {
    const double of_luminaires = lamp_rays_.power() / power_,
                 of_sources = source_rays_.power() / power_;
    double choice = uniform(key, Purpose::sender_choice);
    if (choice < of_luminaires)
        return from_luminaire(key, choice / of_luminaires, share / of_luminaires, found);
    choice -= of_luminaires;
    if (choice < of_sources || sky_rays_.power() == 0)
        return from_source(source_rays_.draw(choice / of_sources, place_on_light(key)), key,
                           share / of_sources, found);
    from_sky(sky_rays_.draw(key), key, share * power_ / sky_rays_.power(), found);
}

/// Follows light from surface to surface on a straight line. at_surface(path, vertex) returns
/// whether the line goes on behind the vertex.
template <class AtSurface>
void LightPaths::walk(PathState path, const AtSurface& at_surface) const {
    const Key key = path.key;
    for (int met = 0; met < max_surfaces_along; ++met) {
        path.key = key.branched(Branch::light_path, static_cast<std::uint32_t>(met));
        Hit hit;
        if (!world_.first_hit(path.ray, path.tolerance, path.kind, hit)) return;
        const Vertex vertex =
            vertex_at(world_, path.ray, hit, {path.media.data(), path.media.size()});
        if (!at_surface(path, vertex)) return;
        path.media = interface_at(world_, path.media, hit.primitive, path.band).behind;
        path.ray.origin = vertex.position();
        path.tolerance = vertex.tolerance();
    }
}

void LightPaths::from_luminaire(const Key& key, double choice, double share, Found& found) const {
    const auto drawn = lamp_rays_.draw(key, choice, share, [&](const Luminaire& luminaire) {
        return shot_.inner_rays(luminaire);
    });
    if (!drawn) return;
    const Vec3 begin = drawn->path.ray.origin;
    // Attenuates light to each surface on the way as a shadow ray from that surface would.
    walk(drawn->path, [&](const PathState& path, const Vertex& vertex) {
        const WayOfLight way = way_back(vertex, begin);
        const Rgb left = light_left(world_, way, path.key);
        if (left != Rgb(0) && !is_brought(way, vertex)) {
            Rgb seen(0), by_lamp(0);
            world_.lights.visit(drawn->light, [&](const auto& glowing) {
                seen = radiance_seen(world_, glowing, {way.ray, way.tolerance, way.distance});
                if (seen != Rgb(0)) by_lamp = left_by_lamp(world_, glowing, way, path.key);
            });
            if (seen == Rgb(0)) return false;
            Lit lit{path, vertex, drawn->power_of_one * left * by_lamp * seen, 0,
                    Lamp::luminaire(drawn->light)};
            if (reflect(lit)) go_on(std::move(lit), found);
        }
        return world_.passed(vertex.hit, path.ray) != Rgb(0);
    });
}

void LightPaths::from_sky(const SkyRays::Drawn& drawn, const Key& key, double share,
                          Found& found) const {
    walk(start(key, drawn.ray), [&](const PathState& path, const Vertex& vertex) {
        const WayOfLight way{.ray = {vertex.position(), -path.ray.direction},
                             .tolerance = vertex.tolerance(),
                             .distance = far_away,
                             .ends = false,
                             .around = vertex.around};
        Lit lit{path, vertex, share * drawn.power * light_left(world_, way, path.key)};
        if (lit.power != Rgb(0) && !is_brought(way, vertex) && reflect(lit))
            go_on(std::move(lit), found);
        return world_.passed(vertex.hit, path.ray) != Rgb(0);
    });
}

/// Light of a source that has a grid, a disc or no shadow may also light what lies behind a surface
/// on the straight line from its location: half of the lines go on there.
void LightPaths::from_source(const SourceRays::Drawn& drawn, const Key& key, double share,
                             Found& found) const {
    const PointLight& light = world_.lights.sources[drawn.number];
    const bool by_line = !light.is_area() && light.disc_edge == 1 && !light.shadowless;
    const Ray& ray = drawn.ray.ray;
    const std::uint32_t group = world_.lights.reach[drawn.number].group;
    const double ahead = dot(light.location - ray.origin, ray.direction);
    walk(start(key, ray), [&](const PathState& path, const Vertex& vertex) {
        const double way = dot(vertex.position() - ray.origin, ray.direction);
        if (world_.reaches(group, *vertex.material)) {
            const double area = share * drawn.ray.area_after(way);
            const Rgb colour = incidence(light, light.location, vertex.position()).colour;
            Lit lit{path, vertex, area * colour, 0, Lamp::source(drawn.number)};
            if (reflect_source(drawn.number, area, lit)) go_on(std::move(lit), found);
        }
        // Nothing before the plane of a parallel light casts a shadow.
        if (way < ahead || world_.passed(vertex.hit, path.ray) != Rgb(0)) return true;
        if (by_line || uniform(path.key, Purpose::behind_on_line) < 0.5) return false;
        share *= 2;
        return true;
    });
}

/// Whether photons bring this light, as it goes through one of their targets.
bool LightPaths::is_brought(const WayOfLight& way, const Vertex& vertex) const {
    return !world_.photon_targets.empty() && vertex.material->photons.collects &&
           target_between(world_, ways_of_luminaires, way.ray, way.tolerance, way.distance);
}

PathState LightPaths::start(const Key& key, const Ray& ray) const {
    PathState path;
    path.ray = ray;
    path.kind = RayKind::gathering;
    path.key = key;
    path.media = world_.containing(ray.origin);
    return path;
}

/// Radiance that the even layers show on the side of the vertex, equal in all directions, for light
/// of colour 1 that arrives along the path's ray.
Rgb LightPaths::reflected(const PathState& path, const Vertex& vertex) const {
    Rgb sum(0);
    for (const VisibleTexture& each : visible_textures(world_, vertex))
        LayerStack(world_, path, vertex, each.layers).visit([&](const LayerStack::Seen& layer) {
            if (!is_even_on_each_side(world_, vertex, layer.shading)) return;
            sum += each.weight * layer.through *
                   Bsdf(layer.shading, rules_).evaluate(-path.ray.direction, diffuse_terms, 0);
        });
    return sum;
}

/// The same by light of a source, as it arrives at the vertex.
Rgb LightPaths::reflected_of_source(std::uint32_t number, const PathState& path,
                                    const Vertex& vertex) const {
    LightLedger uncounted;
    Rgb sum(0);
    for (const VisibleTexture& each : visible_textures(world_, vertex))
        LayerStack(world_, path, vertex, each.layers).visit([&](const LayerStack::Seen& layer) {
            if (!is_even_on_each_side(world_, vertex, layer.shading)) return;
            const Bsdf bsdf(layer.shading, rules_);
            const LitLayer lit{.vertex = vertex,
                               .scatterer = bsdf,
                               .light = all_sources,
                               .highlights = false,
                               .samples_grids = true};
            sum +=
                each.weight * layer.through *
                light_of_source(number, 1, {world_, lit, !world_.photon_targets.empty(), uncounted},
                                path.key);
        });
    return sum;
}

/// The place of a vertex as it is seen from the other side.
Vertex LightPaths::other_side(const PathState& path, const Vertex& vertex) const {
    const Ray back{vertex.position() + path.ray.direction, -path.ray.direction};
    return vertex_at(world_, back, vertex.hit, vertex.around);
}

/// Finds what the vertex reflects on both sides. Returns false if that is nothing.
bool LightPaths::reflect(Lit& lit) const {
    const double cosine = -dot(lit.path.ray.direction, lit.vertex.shading.geometric_normal);
    if (cosine < grazing_cosine) return false;
    lit.front = lit.power * reflected(lit.path, lit.vertex) / cosine;
    lit.back = lit.vertex.material->lit_from_behind
                   ? lit.power * reflected(lit.path, other_side(lit.path, lit.vertex)) / cosine
                   : Rgb(0);
    return lit.front != Rgb(0) || lit.back != Rgb(0);
}

/// The same for light of a source. `area`: perpendicular to the ray, for which it stands.
bool LightPaths::reflect_source(std::uint32_t number, double area, Lit& lit) const {
    const double cosine =
        std::abs(dot(lit.path.ray.direction, lit.vertex.shading.geometric_normal));
    if (cosine < grazing_cosine) return false;
    lit.front = area / cosine * reflected_of_source(number, lit.path, lit.vertex);
    // With `area_illumination` the grid decides which side is lit.
    if (!lit.vertex.material->lit_from_behind && !world_.lights.sources[number].area_illumination)
        return lit.front != Rgb(0);
    PathState behind = lit.path;
    if (lit.vertex.material->transparent)
        behind.media =
            interface_at(world_, behind.media, lit.vertex.hit.primitive, behind.band).behind;
    Vertex seen = other_side(lit.path, lit.vertex);
    seen.around = {behind.media.data(), behind.media.size()};
    lit.back = area / cosine * reflected_of_source(number, behind, seen);
    return lit.front != Rgb(0) || lit.back != Rgb(0);
}

/// Follows the path from surface to surface as long as they reflect it.
void LightPaths::go_on(Lit lit, Found& found) const {
    while (++lit.reflections <= max_reflections_) {
        const auto leave = [&](const Rgb& power, const Vec3& normal) {
            if (power != Rgb(0))
                found.push_back({lit.vertex.position(), normal, power, lit.vertex.tolerance(),
                                 lit.reflections, lit.lamp});
        };
        const Vec3 normal = lit.vertex.shading.geometric_normal;
        leave(lit.front, normal);
        leave(lit.back, -normal);
        const double in_front = max_abs_component(lit.front), behind = max_abs_component(lit.back),
                     all = in_front + behind;
        const double survival =
            std::clamp(all / max_abs_component(lit.power), min_light_survival, 1.0);
        if (uniform(lit.path.key, Purpose::roulette) >= survival) return;
        const bool passes = uniform(lit.path.key, Purpose::way_choice) * all < behind;
        lit.power =
            (passes ? lit.back : lit.front) / (survival * ((passes ? behind : in_front) / all));
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
        if (world_.facts.dims_between)
            lit.power *= light_left(world_, way_back(lit.vertex, from), lit.path.key);
        if (lit.power == Rgb(0) || !reflect(lit)) return;
    }
}

}  // namespace candelabra
