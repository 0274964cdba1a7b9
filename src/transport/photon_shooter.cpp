// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/photon_shooter.h"

#include "base/degrees.h"
#include "base/elementary.h"
#include "lighting/draw.h"
#include "transport/lamp_rays.h"
#include "transport/light_left.h"
#include "transport/sight.h"

#include <algorithm>
#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Maximum number of photons at a time: more take more memory than they are worth.
constexpr double max_photons = 1 << 18;
/// Minimum weight of a shaped light for a target that its shape touches, as a fraction of the
/// weight without its shape.
constexpr double min_share = 0.05;
/// Maximum number of pairs of luminaires and targets whose light is estimated.
constexpr std::size_t max_lamp_pairs = std::size_t{1} << 24;
/// Ray tolerance of a luminaire's photons, as a fraction of their distance or of the ball's radius.
constexpr double away_from_lamp = 1e-7;

/// Approximate light of a light source at a target.
double light_at(const PointLight& light, const PhotonTarget& target) {
    const Vec3 there = target.centre;
    PointLight plain = light;
    plain.beam = all_around;
    plain.web = nullptr;
    plain.parallel = light.along_axis();
    const double most = std::abs(grey(incidence(plain, light.location, there).colour));
    const Vec3 offset = there - light.location, axis = axis_of(light);
    const double away = length(offset);
    bool touches = true;
    if (light.kept_to() == parallel_beam) {
        const double aside = length(offset - dot(offset, axis) * axis);
        touches = aside < light.falloff.value_or(1) + target.radius;
    } else if (light.kept_to() == cone && !light.parallel && away > target.radius) {
        const double angle = math::acos(std::clamp(dot(offset, axis) / away, -1.0, 1.0));
        touches = angle - math::asin(target.radius / away) <
                  light.falloff.value_or(45) * radians_per_degree;
    }
    if (!touches) return 0;
    return std::clamp(std::abs(grey(incidence(light, light.location, there).colour)),
                      min_share * most, most);
}

bool shoots_at(const PhotonWays& lamp, const PhotonTarget& target) {
    return target.shot_at && any_open(lamp, target.ways);
}

double shadow_of(const PhotonTarget& target) { return pi * target.radius * target.radius; }

/// Returns the cap of a target's ball from which a luminaire may be visible, as a cone from the
/// centre. The luminaire is bounded by a ball, too.
LightCone cap_towards(const LightBounds& luminaire, const PhotonTarget& target) {
    const Vec3 offset = luminaire.centre - target.centre;
    const double away = length(offset), above = target.radius - luminaire.radius;
    if (away <= std::abs(above)) return {Vec3(0, 0, 1), -1};
    return {offset / away, above / away};
}

/// A point of the ball, given by its normal, and its pdf per steradian from the centre.
struct Entry {
    Vec3 normal;
    double density;
};

/// Samples a point of the cap: uniformly in its projection along the axis if the projection shows
/// all of the cap, otherwise uniformly per steradian.
Entry draw_entry(const LightCone& cap, const Vec2& u) {
    if (cap.cosine < 0) return {direction_in_cone(cap, u), 1 / cap.steradians()};
    const double seen = 1 - cap.cosine * cap.cosine;
    const Vec3 aside = point_in_disc(cap.axis, std::sqrt(seen), u);
    const double height = std::sqrt(std::fmax(1 - dot(aside, aside), 0));
    return {unit(aside + height * cap.axis), height / (pi * seen)};
}

bool is_ball(const Luminaire& luminaire) {
    return std::holds_alternative<SphereEmitter>(luminaire.emitter);
}
bool is_ball(const MediaBox&) { return false; }

/// Area that has about the light of the lamp if it has the maximum radiance everywhere.
double bright_area(const Luminaire& luminaire) { return emitting_area(luminaire.emitter); }
double bright_area(const MediaBox& box) { return area_of_equal_light(box); }

std::optional<SearchedLuminaire> searched_among(const Luminaire& luminaire) {
    return SearchedLuminaire::of(luminaire);
}
std::optional<SearchedLuminaire> searched_among(const MediaBox&) { return std::nullopt; }

/// Approximate fraction of a luminaire or a box of media that lies in the ball around a target; 0:
/// none.
template <class Glowing>
double share_inside(const Glowing& glowing, const PhotonTarget& target) {
    const LightBounds around = bounds(glowing);
    const double away = length(around.centre - target.centre);
    if (away >= around.radius + target.radius) return 0;
    // The whole surface of a large ball may be outside.
    if (is_ball(glowing) && around.radius - away >= target.radius) return 0;
    const double outside = (away + around.radius - target.radius) / (2 * around.radius);
    return std::clamp(1 - outside, min_share, 1.0);
}

}  // namespace

PhotonShooter::PhotonShooter(const Shot& shot) : shot_(shot), world_(*shot.world) {
    for (std::uint32_t target = 0; target < world_.photon_targets.size(); ++target) {
        aim_sources(target);
        aim_luminaires(target);
    }
}

void PhotonShooter::add(Aim aim) {
    const PhotonTarget& target = world_.photon_targets[aim.target];
    aim.weight /= target.spacing * target.spacing;
    if (!(aim.weight > 0) || !std::isfinite(aim.weight)) return;
    aim.until = weight() + aim.weight;
    aims_.push_back(aim);
}

void PhotonShooter::aim_sources(std::uint32_t number) {
    const PhotonTarget& target = world_.photon_targets[number];
    for (std::uint32_t i = 0; i < world_.lights.sources.size(); ++i) {
        if (!shoots_at(ways_of_source(world_, i), target)) continue;
        const double light = light_at(world_.lights.sources[i], target);
        add({Aim::source, i, number, light * shadow_of(target)});
    }
}

void PhotonShooter::aim_luminaires(std::uint32_t number) {
    const PhotonTarget& target = world_.photon_targets[number];
    if (!shoots_at(ways_of_luminaires, target)) return;
    const WorldLights& lights = world_.lights;
    const std::size_t step = 1 + lights.glowing() * world_.photon_targets.size() / max_lamp_pairs;
    const Receiver middle{target.centre, Vec3(0), Horizon::none};
    double light = 0;
    LightIndex i = 0;
    lights.for_each_glowing([&](const auto& glowing) {
        const double inside = share_inside(glowing, target);
        const double brightness = luminance(glowing.radiance);
        if (inside > 0) add({Aim::inner, i, number, inside * brightness * bright_area(glowing)});
        if (i++ % step != 0) return;
        // The estimate is unbounded close to a luminaire.
        const double here = std::fmin(unoccluded(glowing, middle) / pi, 4 * brightness);
        light += static_cast<double>(step) * std::fmax(1 - inside, min_share) * here;
    });
    add({Aim::luminaires, 0, number, light * shadow_of(target)});
}

std::uint32_t PhotonShooter::count() const {
    const PhotonSettings& settings = world_.rules.settings.photons;
    double count = settings.count;
    if (!(count > 0)) {
        count = 0;
        for (const Aim& aim : aims_) {
            const PhotonTarget& target = world_.photon_targets[aim.target];
            const double spacing = settings.spacing * target.spacing;
            count += shadow_of(target) / (spacing * spacing);
        }
    }
    return static_cast<std::uint32_t>(std::clamp(count, 1.0, max_photons));
}

std::optional<PhotonShot> PhotonShooter::shoot(const Aim& aim, const Key& key) const {
    const PhotonTarget& target = world_.photon_targets[aim.target];
    PhotonShot shot;
    shot.target = aim.target + 1;
    if (aim.kind != Aim::source) {
        shot.ways = ways_of_luminaires;
        return aim.kind == Aim::inner ? from_inside(aim.lamp, target, shot, key)
                                      : from_luminaires(target, shot, key);
    }
    return from_source(aim.lamp, target, shot, key);
}

std::optional<PhotonShot> PhotonShooter::from_source(std::uint32_t number,
                                                     const PhotonTarget& target, PhotonShot shot,
                                                     const Key& key) const {
    shot.lamp = Lamp::source(number);
    shot.ways = ways_of_source(world_, number);
    shot.light_group = world_.lights.reach[number].group;
    const PointLight& light = world_.lights.sources[number];
    Vec3 place = light.location;
    if (light.is_area() && world_.lights.reach[number].photons_of_grid)
        place = drawn_grid_point(light, place_in_grid(key), unit(light.location - target.centre));
    shot.of_source = ray_into({target.centre, target.radius}, light, place, place_on_light(key));
    if (!shot.of_source) return std::nullopt;
    shot.ray = shot.of_source->ray;
    return shot;
}

/// Radiance of a luminaire at a point on the ray.
Rgb PhotonShooter::seen(const Luminaire& luminaire, const Ray& ray, double distance,
                        const Key& key) const {
    const Rgb radiance = radiance_seen(world_, luminaire, {ray, 0, distance});
    // A photon's own way dims it by the media that it starts in.
    if (radiance == Rgb(0) || !world_.material(luminaire.primitive).no_shadow) return radiance;
    const EnteredSolids around = world_.containing(ray.origin);
    const WayOfLight way{
        .ray = ray, .distance = distance, .around = {around.data(), around.size()}};
    return radiance * left_by_lamp(world_, luminaire, way, key);
}

/// Radiance of media per unit of length.
Rgb PhotonShooter::seen(const MediaBox& box, const Ray& ray, double distance,
                        const Key& key) const {
    return radiance_seen(world_, box, {ray, 0, distance}) *
           left_by_fog_behind(world_, ray, distance, key);
}

/// A point that sends light to the place where a photon enters the ball of its target.
struct PhotonShooter::Sender {
    Vec3 start, direction;  ///< from the entry to the start
    Rgb radiance;
    double density;  ///< as that of LightPoint
};

/// Of a luminaire or a box of media.
template <class Glowing>
std::optional<PhotonShooter::Sender> PhotonShooter::sender(const Glowing& glowing, LightIndex,
                                                           const Receiver& entry,
                                                           const Key& key) const {
    const auto point = sample(glowing, entry, place_on_light(key));
    if (!point) return std::nullopt;
    return Sender{point->position, point->direction,
                  seen(glowing, {entry.position, point->direction}, point->distance, key),
                  point->density};
}

/// Of several points on the line, as of a clear lamp, one is drawn.
std::optional<PhotonShooter::Sender> PhotonShooter::sender(const SearchedLuminaire& searched,
                                                           LightIndex light, const Receiver& entry,
                                                           const Key& key) const {
    const auto drawn = searched.draw(entry.position, place_on_light(key));
    if (!drawn) return std::nullopt;
    const LuminaireAt lamp = world_.lights.luminaires[light];
    const Luminaire& luminaire = *lamp;
    Sender sender{Vec3(0), drawn->direction, Rgb(0), drawn->density};
    double met = 0;
    const Ray ray{entry.position, drawn->direction};
    world_.along(ray, 0, RayKind::light, [&](const Hit& hit, double) {
        if (world_.luminaire_of(hit.primitive) != light) return true;
        ++met;
        const Key own = key.with_branch(static_cast<std::uint32_t>(met));
        if (uniform(own, Purpose::photon_start) * met < 1) {
            sender.start = hit.position;
            sender.radiance = radiance_of(world_, luminaire, emitting_point(hit, ray));
        }
        return !world_.material(hit.primitive).stops_light();
    });
    sender.radiance *= met;
    return sender;
}

/// Samples a ray into the ball by its entry point, which faces the luminaire. The luminaire is
/// chosen for the centre of the ball.
std::optional<PhotonShot> PhotonShooter::from_luminaires(const PhotonTarget& target,
                                                         PhotonShot shot, const Key& key) const {
    const Receiver middle{target.centre, Vec3(0), Horizon::none};
    const auto look = [&](const Ray& ray, double tolerance) {
        return first_sight(world_, ray, tolerance);
    };
    const LightProbe scene(look);
    const BsdfLobes lobes;
    LightSamples samples;
    std::visit(
        [&](const auto& strategy) {
            strategy.at({middle, lobes, nullptr, &scene}).sample(key, samples);
        },
        shot_.sampler);
    if (samples.picks.empty()) return std::nullopt;
    // A strategy may pick several luminaires: one of them is used.
    const auto picks = static_cast<double>(samples.picks.size());
    const LightPick pick =
        samples.picks[static_cast<std::size_t>(uniform(key, Purpose::photon_lamp) * picks)];
    const LightBounds around =
        world_.lights.visit(pick.light, [](const auto& glowing) { return bounds(glowing); });
    const Entry drawn = draw_entry(cap_towards(around, target), {uniform(key, Purpose::photon_u),
                                                                 uniform(key, Purpose::photon_v)});
    const Vec3& normal = drawn.normal;
    const Receiver entry{target.centre + target.radius * normal, normal, Horizon::one_side};
    const auto sent = world_.lights.visit(pick.light, [&](const auto& glowing) {
        const auto searched = searched_among(glowing);
        return searched ? sender(*searched, pick.light, entry, key)
                        : sender(glowing, pick.light, entry, key);
    });
    if (!sent) return std::nullopt;
    const double density = drawn.density * pick.expected / picks * sent->density,
                 cosine = dot(sent->direction, normal);
    if (sent->radiance == Rgb(0) || !(cosine > 0 && density > 0)) return std::nullopt;
    if (length(sent->start - target.centre) <= target.radius) return std::nullopt;
    shot.lamp = Lamp::luminaire(pick.light);
    shot.power = sent->radiance * (target.radius * target.radius * cosine / (pi * density));
    shot.ray = {sent->start, -sent->direction};
    shot.tolerance = away_from_lamp * length(sent->start - entry.position);
    return shot;
}

std::optional<EmittedRay> PhotonShooter::emitted(const Luminaire& luminaire, const Key& key) const {
    return emit(luminaire, shot_.inner_rays(luminaire), emission_draw(key));
}
std::optional<EmittedRay> PhotonShooter::emitted(const MediaBox& box, const Key& key) const {
    return emit(box, emission_draw(key));
}

/// How far from the start of a ray in the ball its light is seen: from a place on the ray.
std::optional<double> PhotonShooter::seen_from(const Luminaire&, const Ray&,
                                               const PhotonTarget& target) const {
    return target.radius;
}
/// Light of media is seen from the first surface, if there is one.
std::optional<double> PhotonShooter::seen_from(const MediaBox&, const Ray& ray,
                                               const PhotonTarget& target) const {
    Hit hit;
    if (!world_.first_hit(ray, away_from_lamp * target.radius, RayKind::light, hit))
        return std::nullopt;
    return (1 - away_from_lamp) * length(hit.position - ray.origin);
}

/// Samples a ray that starts in the ball. Rays that start outside are sampled by their entry point
/// instead.
std::optional<PhotonShot> PhotonShooter::from_inside(LightIndex light, const PhotonTarget& target,
                                                     PhotonShot shot, const Key& key) const {
    return world_.lights.visit(light, [&](const auto& glowing) -> std::optional<PhotonShot> {
        const auto sent = emitted(glowing, key);
        if (!sent || length(sent->ray.origin - target.centre) > target.radius) return std::nullopt;
        const auto away = seen_from(glowing, sent->ray, target);
        if (!away) return std::nullopt;
        const Rgb radiance = seen(glowing, {sent->ray.at(*away), -sent->ray.direction}, *away, key);
        if (radiance == Rgb(0)) return std::nullopt;
        shot.lamp = Lamp::luminaire(light);
        shot.power = radiance * (dot(sent->normal, sent->ray.direction) / (pi * sent->density));
        shot.ray = sent->ray;
        shot.tolerance = away_from_lamp * target.radius;
        return shot;
    });
}

}  // namespace candelabra
