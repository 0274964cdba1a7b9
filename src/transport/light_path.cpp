// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/light_path.h"

#include "base/cosine_direction.h"
#include "lighting/draw.h"
#include "scattering/bsdf.h"
#include "surface/lambertian.h"
#include "transport/aim.h"
#include "transport/light_in_air.h"
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
/// Fraction of the directions that lead to what is seen, of those in which light goes on from
/// outside of the lit region: "Indirect light".
constexpr double aimed = 0.5;

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
      sky_rays_(world_, region_, seen_),
      power_(lamp_rays_.power() + source_rays_.power() + sky_rays_.power()),
      max_reflections_(max_reflections),
      in_air_(stands_for_scattering(world_)) {
    if (!seen_.empty()) learn();
}

/// Finds which starts of paths of sources bring light to what is seen.
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
            const Vec3 offset = each.position - place.position;
            const Vec3 facing = each.in_air() ? -unit(offset) : each.normal;
            if (!sees(world_, place, each.position, facing, each.tolerance)) continue;
            const double away2 = dot(offset, offset);
            const double cosines = dot(offset, place.normal) * -dot(offset, facing) / away2;
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
}

/// A light path that has arrived at a vertex, or at a place in a medium.
struct LightPaths::Lit {
    PathState path;
    Vertex vertex;
    Rgb power;  ///< colour of light times area perpendicular to the ray
    int reflections = 0;
    Lamp lamp = Lamp::sky();
    /// Radiance, on the side of the ray, times area; in a medium, see ReflectedLuminaire::power.
    Rgb front = Rgb(0);
    Rgb back = Rgb(0);  ///< the same on the other side
    /// In a medium: how it scatters, times the length for which the place stands.
    std::optional<PhaseFunction::Part> medium = {};

    /// The light that leaves a place in a medium, on the scale of the power.
    double sent_on() const {
        return 4 * mean_phase(*medium->scattering) * max_abs_component(front);
    }
    /// What a place in a medium scatters of the light. Returns false if that is nothing.
    bool scatter() {
        front = power * medium->coefficient;
        return front != Rgb(0);
    }
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
    const double of_sky = sky_rays_.power() / power_;
    from_sky(sky_rays_.draw(std::fmin((choice - of_sources) / of_sky, below_1), key), key,
             share / of_sky, found);
}

/// A place on the path's ray where media scatter its light, before a distance that may be infinite,
/// for light of colour 1. `scattered`: a medium without `multiple` has scattered it before.
std::optional<LightPaths::Lit> LightPaths::in_air(const PathState& path, double distance,
                                                  bool scattered) const {
    if (!in_air_) return std::nullopt;
    MediaList media;
    add_followed(world_, {path.media.data(), path.media.size()}, std::isfinite(distance), media);
    const LightInAir light = scattered ? LightInAir::repeatedly_only : LightInAir::any;
    if (std::ranges::none_of(media, [&](const Media* each) { return each->scatters(light); }))
        return std::nullopt;
    PathState there = path;
    there.key = path.key.branched(Branch::medium);
    const PatternScene scene = world_.pattern_scene();
    const auto place = place_on_line(view_of(media), path.ray, distance, region_, scene, there.key);
    if (!place) return std::nullopt;
    const PhaseFunction phase(view_of(media), path.ray.at(place->distance), path.ray.direction,
                              scene, Rgb(1), light);
    if (!phase.answers_light()) return std::nullopt;
    PhaseFunction::Part part = phase.part(uniform(there.key, Purpose::media_lobe));
    part.coefficient *= place->stands_for / part.share;
    const Vertex vertex =
        vertex_in_air(world_, path.ray, place->distance, {path.media.data(), path.media.size()});
    there.scattered = scattered || !part.scattering->multiple;
    return Lit{.path = there, .vertex = vertex, .power = Rgb(1), .medium = part};
}

/// Follows light from surface to surface on a straight line. at_surface(path, vertex) returns
/// whether the line goes on behind the vertex. at_place(lit) is called for places between surfaces.
template <class AtPlace, class AtSurface>
void LightPaths::walk(PathState path, const AtPlace& at_place, const AtSurface& at_surface) const {
    const Key key = path.key;
    for (int met = 0; met < max_surfaces_along; ++met) {
        path.key = key.branched(Branch::light_path, static_cast<std::uint32_t>(met));
        Hit hit;
        const bool found = world_.first_hit(path.ray, path.tolerance, path.kind, hit);
        const double distance = found ? length(hit.position - path.ray.origin) : INFINITY;
        if (const auto place = in_air(path, distance, false)) at_place(*place);
        if (!found) return;
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
    const auto arriving = [&](const Vertex& vertex, const Key& own, bool& glows) {
        const WayOfLight way = way_back(vertex, begin);
        const Rgb left = light_left(world_, way, own);
        if (left == Rgb(0) || is_brought(way, vertex)) return Rgb(0);
        Rgb seen(0), by_lamp(0);
        world_.lights.visit(drawn->light, [&](const auto& glowing) {
            seen = radiance_seen(world_, glowing, {way.ray, way.tolerance, way.distance});
            if (seen != Rgb(0)) by_lamp = left_by_lamp(world_, glowing, way, own);
        });
        glows = seen != Rgb(0);
        return drawn->power_of_one * left * by_lamp * seen;
    };
    const Lamp lamp = Lamp::luminaire(drawn->light);
    walk(
        drawn->path,
        [&](Lit lit) {
            bool glows = true;
            lit.lamp = lamp;
            lit.power = arriving(lit.vertex, lit.path.key, glows);
            if (lit.scatter()) go_on(std::move(lit), found);
        },
        [&](const PathState& path, const Vertex& vertex) {
            bool glows = true;
            const Rgb power = arriving(vertex, path.key, glows);
            if (!glows) return false;
            Lit lit{path, vertex, power, 0, lamp};
            if (power != Rgb(0) && reflect(lit)) go_on(std::move(lit), found);
            return world_.passed(vertex.hit, path.ray) != Rgb(0);
        });
}

void LightPaths::from_sky(const SkyRays::Drawn& drawn, const Key& key, double share,
                          Found& found) const {
    const auto arriving = [&](const Vertex& vertex, const Key& own) {
        const WayOfLight way{.ray = {vertex.position(), -drawn.ray.direction},
                             .tolerance = vertex.tolerance(),
                             .distance = far_away,
                             .ends = false,
                             .around = vertex.around};
        const Rgb power = share * drawn.power * light_left(world_, way, own);
        return power != Rgb(0) && is_brought(way, vertex) ? Rgb(0) : power;
    };
    walk(
        start(key, drawn.ray),
        [&](Lit lit) {
            lit.power = arriving(lit.vertex, lit.path.key);
            if (lit.scatter()) go_on(std::move(lit), found);
        },
        [&](const PathState& path, const Vertex& vertex) {
            Lit lit{path, vertex, arriving(vertex, path.key)};
            if (lit.power != Rgb(0) && reflect(lit)) go_on(std::move(lit), found);
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
    const Lamp lamp = Lamp::source(drawn.number);
    const auto area_at = [&](const Vertex& vertex) {
        return share * drawn.ray.area_after(dot(vertex.position() - ray.origin, ray.direction));
    };
    walk(
        start(key, ray),
        [&](Lit lit) {
            if (!world_.reaches(group, *lit.vertex.material)) return;
            lit.lamp = lamp;
            lit.power =
                area_at(lit.vertex) * arriving_of_source(drawn.number, lit.vertex, lit.path);
            if (lit.scatter()) go_on(std::move(lit), found);
        },
        [&](const PathState& path, const Vertex& vertex) {
            if (world_.reaches(group, *vertex.material)) {
                const double area = area_at(vertex);
                const Rgb colour = incidence(light, light.location, vertex.position()).colour;
                Lit lit{path, vertex, area * colour, 0, lamp};
                if (reflect_source(drawn.number, area, lit)) go_on(std::move(lit), found);
            }
            // Nothing before the plane of a parallel light casts a shadow.
            const double way = dot(vertex.position() - ray.origin, ray.direction);
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

/// Colour of a source's light that arrives at a place in a medium.
Rgb LightPaths::arriving_of_source(std::uint32_t number, const Vertex& vertex,
                                   const PathState& path) const {
    static const Media even = [] {
        Media media;
        media.scattering.colour = Rgb(1);
        return media;
    }();
    const Media* const list[] = {&even};
    const PhaseFunction phase(list, vertex.position(), path.ray.direction, world_.pattern_scene());
    const LitLayer lit{
        .vertex = vertex, .scatterer = phase, .light = all_sources, .samples_grids = true};
    LightLedger uncounted;
    return light_of_source(number, 1, {world_, lit, false, uncounted}, path.key);
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

/// Leaves reflected luminaires where the path is.
void LightPaths::leave(const Lit& lit, Found& found) const {
    const auto add = [&](const Rgb& power, const Vec3& normal) {
        if (power != Rgb(0))
            found.push_back({lit.vertex.position(), normal, power, lit.vertex.tolerance(),
                             lit.reflections, lit.lamp,
                             lit.medium ? lit.medium->scattering : nullptr, lit.path.scattered});
    };
    if (lit.medium) return add(lit.front, lit.path.ray.direction);
    const Vec3 normal = lit.vertex.shading.geometric_normal;
    add(lit.front, normal);
    add(lit.back, -normal);
}

/// Sends the path on from where it is. Returns false if it ends.
bool LightPaths::send_on(Lit& lit) const {
    const Key& key = lit.path.key;
    if (lit.medium) {
        const Vec3 ahead = lit.path.ray.direction;
        const Aim aim(region_, lit.vertex.position(), aimed);
        const Vec3 direction = aim.draw(
            {uniform(key, Purpose::media_direction_u), uniform(key, Purpose::media_direction_v)},
            [&](const Vec2& u) {
                return turned_from(ahead, lit.medium->draw_cosine(u.x), 2 * std::numbers::pi * u.y);
            });
        const double cosine = dot(ahead, direction);
        lit.power *= lit.medium->evaluate(cosine) /
                     (std::numbers::pi * aim.density(direction, lit.medium->pdf(cosine)));
        lit.path = path_from_air(lit.path, lit.vertex.position(), direction);
        return true;
    }
    const Vec3 normal = lit.vertex.shading.geometric_normal;
    const double in_front = max_abs_component(lit.front), behind = max_abs_component(lit.back),
                 all = in_front + behind;
    const double survival = std::clamp(all / max_abs_component(lit.power), min_light_survival, 1.0);
    if (uniform(key, Purpose::roulette) >= survival) return false;
    const bool passes = uniform(key, Purpose::way_choice) * all < behind;
    lit.power = (passes ? lit.back : lit.front) / (survival * ((passes ? behind : in_front) / all));
    const Vec3 side = passes ? -normal : normal, place = lit.vertex.position();
    const Aim aim(region_, place, region_.greatest_cosine(place, side) > 0 ? aimed : 0);
    const Vec3 direction =
        aim.draw({uniform(key, Purpose::bounce_u), uniform(key, Purpose::bounce_v)},
                 [&](const Vec2& u) { return cosine_direction(side, u); });
    const double density = dot(direction, side) / std::numbers::pi;
    if (!(density > 0)) return false;
    lit.power *= density / aim.density(direction, density);
    lit.path = passes ? gathering_path_behind(world_, lit.path, lit.vertex, direction)
                      : gathering_path(lit.path, lit.vertex, direction);
    return true;
}

/// Follows the path to where it is reflected or scattered next. Returns false if it ends.
bool LightPaths::arrive(Lit& lit) const {
    Hit hit;
    const bool met = world_.first_hit(lit.path.ray, lit.path.tolerance, lit.path.kind, hit);
    if (!met && !in_air_) return false;
    const Vec3 from = lit.path.ray.origin;
    const double distance = met ? length(hit.position - from) : INFINITY;
    const Rgb before = lit.power;
    auto scattered = in_air(lit.path, distance, lit.path.scattered);
    if (scattered) {
        scattered->reflections = lit.reflections;
        scattered->lamp = lit.lamp;
        scattered->power = before * left_on_free_way(world_, way_back(scattered->vertex, from),
                                                     scattered->path.key);
        if (!scattered->scatter()) scattered.reset();
    }
    bool reflected = false;
    lit.medium.reset();
    if (met) {
        lit.vertex =
            vertex_at(world_, lit.path.ray, hit, {lit.path.media.data(), lit.path.media.size()});
        if (world_.facts.dims_between)
            lit.power *= light_left(world_, way_back(lit.vertex, from), lit.path.key);
        reflected = lit.power != Rgb(0) && reflect(lit);
    }
    if (!scattered) return reflected;
    const double in_air = scattered->sent_on(),
                 at_surface =
                     reflected ? max_abs_component(lit.front) + max_abs_component(lit.back) : 0,
                 all = in_air + at_surface;
    const double survival = std::clamp(all / max_abs_component(before), min_light_survival, 1.0);
    const double choice = uniform(lit.path.key, Purpose::media_event) / survival;
    if (choice >= 1) return false;
    const bool scatters = choice * all < in_air;
    const double chance = survival * (scatters ? in_air : at_surface) / all;
    if (scatters) {
        lit = std::move(*scattered);
        lit.vertex.around = {lit.path.media.data(), lit.path.media.size()};
    }
    lit.power /= chance;
    lit.front /= chance;
    lit.back /= chance;
    return true;
}

/// Follows the path from place to place as long as they reflect or scatter it.
void LightPaths::go_on(Lit lit, Found& found) const {
    while (++lit.reflections <= max_reflections_) {
        leave(lit, found);
        if (!send_on(lit) || !arrive(lit)) return;
    }
}

}  // namespace candelabra
