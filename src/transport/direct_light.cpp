// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/direct_light.h"

#include "base/elementary.h"
#include "base/gamma.h"
#include "base/order.h"
#include "lighting/draw.h"
#include "transport/light_left.h"
#include "transport/point_lights.h"
#include "transport/sight.h"
#include "world/volumes.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Distance beyond all objects.
constexpr double far_away = 1e20;

/// The solids that contain a ray from the vertex.
EnteredSolids solids_along(const World& world, const Vertex& vertex, const Vec3& direction) {
    EnteredSolids inside;
    for (const PrimitiveIndex each : vertex.around) inside.push_back(each);
    const bool behind = dot(direction, vertex.shading.geometric_normal) < 0;
    if (behind && vertex.material->transparent) world.pass(vertex.hit.primitive, inside);
    return inside;
}

/// What dims light on its way to a layer: the same that dims a ray which the layer follows. As in
/// POV-Ray, air dims light that radiosity gathers only if that is asked for.
AirOnWay air_on_way_to(const LitLayer& layer) {
    return layer.radiosity && !layer.radiosity->media ? AirOnWay::none : AirOnWay::followed;
}

/// Maximum number of shadow rays at one hit, where the number varies.
constexpr int max_rays = 32;

/// Standard deviation that Russian roulette of luminaires may add to a sample with other light, in
/// steps of an 8-bit picture.
constexpr double hidden_steps = 4;
/// Minimum probability that luminaires are sampled.
constexpr double min_chance = 1.0 / 256;

/// Response of the layer to light of a luminaire from a direction.
Vec3 answer_to(const LitLayer& layer, const Vec3& direction, const Key& key) {
    // Brilliance does not apply to light that radiosity gathers.
    const BsdfTerms terms{layer.highlights, !layer.radiosity, FacetLobes::wide};
    return layer.scatterer.evaluate(direction, terms, layer.grain(key));
}

/// About the greatest response of a surface, to compare its noise with that of others.
Vec3 straight_answer(const LitLayer& layer, const Key& key) {
    const Bsdf& bsdf = layer.scatterer.bsdf();
    const BsdfTerms terms{layer.highlights, !layer.radiosity, FacetLobes::wide, true};
    return bsdf.evaluate(receiver(bsdf.shading()).normal, terms, layer.grain(key)) +
           Vec3(bsdf.highlights());
}

/// Difference in radiance that amounts to hidden_steps steps of the displayed picture.
double visible_step(double radiance) {
    constexpr double gamma = display_gamma, steps = 255;
    return hidden_steps / steps * gamma * math::pow(std::fmin(radiance, 1), 1 - 1 / gamma);
}

}  // namespace

double LitLayer::grain(const Key& key) const {
    if (scatterer.in_air()) return 0;
    return scatterer.bsdf().shading().finish->crand > 0 ? uniform(key, Purpose::grain) : 0;
}

Vec3 DirectLight::operator()(const LitLayer& layer, const Key& key, LightLedger& ledger) {
    Vec3 sum(0);
    if (!layer.scatterer.answers_light()) return sum;
    if (layer.light.has(LightKind::sources)) sum = from_sources(layer, key, ledger);
    if (photons_ && !layer.scatterer.in_air() && layer.collects())
        sum += photons_(layer, key, ledger, passes_surfaces(world_));
    if (layer.light.has(LightKind::luminaires) && !world_.lights.luminaires.empty())
        sum += from_luminaires(layer, key, sum, ledger);
    if (!layer.light.has(LightKind::sky) || world_.sky.light.empty()) return sum;
    Vec3 of_sky(0);
    const int count = shadow_rays_.usual;
    for (int i = 0; i < count; ++i) {
        medium_key_ = key.part(count, i);
        of_sky += from_sky(layer, medium_key_, ledger);
    }
    return sum + of_sky / static_cast<double>(count);
}

/// Records light from a luminaire, and the number of rays towards it.
void DirectLight::record(LightLedger& ledger, LightIndex light, const Vec3& seen,
                         const Vec3& throughput, std::uint64_t count) const {
    if (ledger.lights.empty()) return;
    LightCount& own = ledger.lights[world_.provenance.statement_of_luminaire[light]];
    own.light.add(grey(seen) / asked_here_);
    own.seen += throughput * seen / asked_here_;
    own.rays += count;
}

/// Radiance from one direction, as radiosity counts it.
Vec3 DirectLight::gathered(const LitLayer& layer, const Vec3& light) {
    return layer.radiosity ? gathered_light(*layer.radiosity, light) : light;
}

Vec3 DirectLight::from_luminaires(const LitLayer& layer, const Key& key, const Vec3& before,
                                  LightLedger& ledger) {
    const Scatterer& scatterer = layer.scatterer;
    const Receiver point = receiver(scatterer);
    const BsdfLobes lobes = scatterer.lobes();
    const auto draw = [&](Vec2 u) { return scatterer.sample(u); };
    const auto pdf = [&](const Vec3& direction) { return scatterer.pdf(direction); };
    const BsdfSampler sampler{scatterer.specular_probability(), draw, pdf};
    const auto look = [&](const Ray& ray, double tolerance) {
        return first_sight(world_, ray, tolerance);
    };
    const LightProbe scene(look);
    return std::visit(
        [&](const auto& strategy) {
            const auto answer = strategy.at({point, lobes, &sampler, &scene});
            int count = shadow_rays_.usual;
            double chance = 1;
            if (answer.noise() >= 0 && scatterer.in_air()) {
                count = rays_at(answer, layer, scatterer.phase().mean());
            } else if (answer.noise() >= 0) {
                const Vec3 straight = straight_answer(layer, key);
                chance = chance_of_asking(answer, layer, straight, before);
                if (chance < 1 && uniform(key, Purpose::light_roulette) >= chance) return Vec3(0);
                count = rays_at(answer, layer, straight);
            }
            asked_here_ = count * chance;
            Vec3 sum(0);
            for (int i = 0; i < count; ++i)
                sum += from_answer(answer, layer, key.part(count, i), ledger);
            return sum / asked_here_;
        },
        world_.lights.sampler);
}

/// Light of luminaires by one shadow ray.
template <LightAnswer Answer>
Vec3 DirectLight::from_answer(const Answer& answer, const LitLayer& layer, const Key& key,
                              LightLedger& ledger) {
    samples_.clear();
    answer.sample(key, samples_);
    medium_key_ = key;
    Vec3 sum(0);
    if (samples_.direction)
        sum += from_direction(*samples_.direction, answer.meetings(), layer, key, ledger,
                              [&](LightIndex light, double of_point) {
                                  return answer.pdf(*samples_.direction,
                                                    answer.expected(key, light), of_point);
                              });
    // The conventional strategy picks every luminaire once; further shadow rays add points on each.
    const bool several = samples_.picks.size() > 1;
    for (const LightPick& pick : samples_.picks) {
        const bool volume = world_.lights.luminaires[pick.light].is_volume();
        sum += from_luminaire(pick, layer, several ? key.with_branch(pick.light) : key, ledger,
                              [&](const Vec3& direction, double of_point) {
                                  return volume ? answer.picked() * pick.expected * of_point
                                                : answer.pdf(direction, pick.expected, of_point);
                              });
    }
    return sum;
}

/// Probability of sampling luminaires (Russian roulette), which is low where their light, by the
/// estimate of the cell, is small against the light from before. The resulting noise is too small
/// to be seen.
template <LightAnswer Answer>
double DirectLight::chance_of_asking(const Answer& at, const LitLayer& layer, const Vec3& straight,
                                     const Vec3& before) const {
    const double share = std::abs(grey(layer.throughput)), there = share * grey(before);
    if (!(there > 0)) return 1;
    const double answer = share * std::abs(grey(straight)) / pi;
    const double mean = answer * at.irradiance(), deviation = answer * at.noise();
    const double squares = mean * mean + deviation * deviation;
    const double visible = visible_step(there);
    return std::clamp(squares / (mean * mean + visible * visible), min_chance, 1.0);
}

/// Number of shadow rays in proportion to the expected noise; a power of two, which suits Sobol
/// points.
template <LightAnswer Answer>
int DirectLight::rays_at(const Answer& answer, const LitLayer& layer, const Vec3& straight) {
    const double noise = answer.noise() * std::abs(grey(layer.throughput * straight));
    noise_.sum += noise;
    noise_.squares += noise * noise;
    ++noise_.hits;
    if (shadow_rays_.usual_noise == 0) return shadow_rays_.usual;
    const double wanted = shadow_rays_.usual * noise / shadow_rays_.usual_noise;
    const double exponent = std::round(math::log2(std::clamp<double>(wanted, 1, max_rays)));
    return 1 << static_cast<int>(exponent);
}

/// Fraction of a luminaire's light that surfaces and media let through. It is 0 where photons bring
/// the light instead.
Vec3 DirectLight::light_left(const LitLayer& layer, const Ray& ray, double distance,
                             bool ends) const {
    const Vertex& vertex = layer.vertex;
    const EnteredSolids around = solids_along(world_, vertex, ray.direction);
    const Vec3 left = candelabra::light_left(world_,
                                             {.ray = ray,
                                              .tolerance = vertex.tolerance(),
                                              .distance = distance,
                                              .ends = ends,
                                              .around = {around.data(), around.size()},
                                              .air = air_on_way_to(layer)},
                                             medium_key_);
    const bool brought =
        photons_ && left != Vec3(0) && layer.collects() &&
        target_between(world_, ways_of_luminaires, ray, vertex.tolerance(), distance);
    return brought ? Vec3(0) : left;
}

/// Radiance of a luminaire at a point on the ray, as the layer sees it; of a volume, per unit of
/// length.
Vec3 DirectLight::emitted(const LitLayer& layer, const Luminaire& luminaire, const Ray& ray,
                          double distance) const {
    const double tolerance = layer.vertex.tolerance();
    Vec3 light(0);
    if (luminaire.is_volume()) {
        const EnteredSolids around = solids_along(world_, layer.vertex, ray.direction);
        light = volume_emission(world_, luminaire.primitive,
                                {ray, tolerance, distance, {around.data(), around.size()}});
    } else {
        light = radiance_seen(world_, {luminaire, ray, tolerance, distance});
    }
    return light == Vec3(0) ? light : light * left_by_lamp(layer, luminaire, ray, distance);
}

/// Fraction of a luminaire's light that its own solid lets through, if other light passes it.
Vec3 DirectLight::left_by_lamp(const LitLayer& layer, const Luminaire& luminaire, const Ray& ray,
                               double distance) const {
    if (!world_.material(luminaire.primitive).no_shadow) return Vec3(1);
    const EnteredSolids around = solids_along(world_, layer.vertex, ray.direction);
    return candelabra::left_by_lamp(world_, luminaire,
                                    {.ray = ray,
                                     .tolerance = layer.vertex.tolerance(),
                                     .distance = distance,
                                     .around = {around.data(), around.size()},
                                     .air = air_on_way_to(layer)},
                                    medium_key_);
}

double DirectLight::expected_luminaires(const Vec3& position) const {
    const Receiver point{position, Vec3(0), Horizon::none};
    const auto look = [&](const Ray& ray, double tolerance) {
        return first_sight(world_, ray, tolerance);
    };
    const LightProbe scene(look);
    const BsdfLobes lobes;
    return std::visit(
        [&](const auto& strategy) {
            return strategy.at({point, lobes, nullptr, &scene}).expected_light();
        },
        world_.lights.sampler);
}

/// Samples a point of the luminaire, and traces its shadow ray.
template <class Density>
Vec3 DirectLight::from_luminaire(const LightPick& pick, const LitLayer& layer, const Key& key,
                                 LightLedger& ledger, const Density& density) {
    const Luminaire& luminaire = world_.lights.luminaires[pick.light];
    const Vec3& position = layer.vertex.position();
    if (const auto searched = SearchedLuminaire::of(luminaire)) {
        const auto drawn = searched->draw(position, place_on_light(key));
        const Vec3 answer = drawn ? answer_to(layer, drawn->direction, key) : Vec3(0);
        if (answer == Vec3(0)) return Vec3(0);
        const Vec3 weight = answer / (pi * density(drawn->direction, drawn->density));
        return seen_towards(layer, drawn->direction, ledger, [&](LightIndex light, double) {
            return light == pick.light ? weight : Vec3(0);
        });
    }
    const auto point = sample(luminaire, receiver(layer.scatterer), place_on_light(key));
    if (!point) return Vec3(0);
    const Vec3 answer = answer_to(layer, point->direction, key);
    if (answer == Vec3(0)) return Vec3(0);
    ++ledger.shadow;
    const Ray ray{position, point->direction};
    Vec3 seen = light_left(layer, ray, point->distance);
    if (seen != Vec3(0)) seen *= emitted(layer, luminaire, ray, point->distance);
    // Light from one steradian of radiance 1 is light of colour 1/pi in POV-Ray's sense.
    if (seen != Vec3(0))
        seen = answer * gathered(layer, seen) / (pi * density(point->direction, point->density));
    record(ledger, pick.light, seen, layer.throughput, 1);
    return seen;
}

/// Light of all luminaires that are visible in the direction, each weighted by its pdf.
template <class Density>
Vec3 DirectLight::from_direction(const Vec3& direction, const LightTree* meetings,
                                 const LitLayer& layer, const Key& key, LightLedger& ledger,
                                 const Density& density) {
    const Vec3 answer = answer_to(layer, direction, key);
    if (answer == Vec3(0)) return Vec3(0);
    const auto weight = [&](LightIndex light, double of_point) {
        return answer / (pi * density(light, of_point));
    };
    if (!meetings) return seen_towards(layer, direction, ledger, weight);
    meet_along(*meetings, layer.vertex, receiver(layer.scatterer), direction);
    return seen_along(layer, direction, ledger, weight);
}

/// Adds the meetings of a searched luminaire behind the first one, which is seen through: the
/// direction is drawn for all of them.
void DirectLight::add_further(const Luminaire& luminaire, const Ray& ray, LightHits& meetings) {
    const auto* searched = std::get_if<CompositeEmitter>(&luminaire.emitter);
    if (!searched) return;
    const double density = meetings.front().density;
    searched->composite->all(
        ray, Interval{meetings.front().distance * (1 + same_point)},
        [&](std::uint32_t leaf) { return leaf == searched->leaf; },
        [&](const Composite::Meeting& met) {
            meetings.push_back({met.t, density});
        });
    sort_stably(meetings, {}, &LightHit::distance);
    // Faces in the same place glow once.
    const auto again = std::ranges::unique(meetings, [](const LightHit& a, const LightHit& b) {
        return b.distance - a.distance <= same_point * b.distance;
    });
    meetings.erase(again.begin(), again.end());
}

/// Fills met_ with all luminaires on the line.
void DirectLight::meet_along(const LightTree& tree, const Vertex& vertex, const Receiver& point,
                             const Vec3& direction) {
    met_.clear();
    tree.along(point.position, direction, [&](LightIndex light) {
        meetings_.clear();
        const Luminaire& luminaire = world_.lights.luminaires[light];
        intersect(luminaire, point, direction, meetings_);
        if (!meetings_.empty() && !world_.material(luminaire.primitive).stops_light())
            add_further(luminaire, {point.position, direction}, meetings_);
        for (const LightHit& meeting : meetings_)
            // The point may lie on a luminaire, which does not light itself there.
            if (meeting.distance > vertex.tolerance()) met_.push_back({meeting, light});
    });
    sort_stably(met_, [](const Met& a, const Met& b) {
        return std::pair(a.meeting.distance, a.light) < std::pair(b.meeting.distance, b.light);
    });
}

/// Radiance of the visible luminaires in met_, each times its weight.
template <class Weight>
Vec3 DirectLight::seen_along(const LitLayer& layer, const Vec3& direction, LightLedger& ledger,
                             const Weight& weight) const {
    Vec3 sum(0);
    const Vertex& vertex = layer.vertex;
    const Ray ray{vertex.position(), direction};
    for (const Met& met : met_) {
        ++ledger.shadow;
        const Luminaire& luminaire = world_.lights.luminaires[met.light];
        const Vec3 passed = light_left(layer, ray, met.meeting.distance);
        if (passed == Vec3(0)) break;
        // Something else may cover it in its place.
        const Vec3 light = passed * emitted(layer, luminaire, ray, met.meeting.distance);
        if (light == Vec3(0)) continue;
        const Vec3 seen = weight(met.light, met.meeting.density) * gathered(layer, light);
        record(ledger, met.light, seen, layer.throughput, 1);
        sum += seen;
        if (world_.material(luminaire.primitive).stops_light()) break;
    }
    return sum;
}

/// Radiance of all luminaires that are visible in a direction, each times its weight.
template <class Weight>
Vec3 DirectLight::seen_towards(const LitLayer& layer, const Vec3& direction, LightLedger& ledger,
                               const Weight& weight) {
    ++ledger.shadow;
    const Vertex& vertex = layer.vertex;
    const Ray ray{vertex.position(), direction};
    Vec3 sum(0);
    met_.clear();
    const bool has_air = world_.has_media() || world_.has_air();
    bool first = true;
    world_.along(ray, vertex.tolerance(), RayKind::light, [&](const Hit& hit, double distance) {
        const bool unobstructed = std::exchange(first, false);
        const bool passes = !world_.material(hit.primitive).stops_light();
        const LightIndex light = world_.lights.luminaire_of[hit.primitive];
        if (light == no_primitive) return passes;
        const Vec3 clear = unobstructed && !has_air ? Vec3(1) : light_left(layer, ray, distance);
        if (clear == Vec3(0)) return false;
        Vec3 weights(0);
        for_densities(light, layer, direction, {distance, hit.tolerance},
                      [&](double density) { weights += weight(light, density); });
        const Luminaire& luminaire = world_.lights.luminaires[light];
        Vec3 seen(0);
        if (weights != Vec3(0))
            seen = weights * gathered(layer, clear * left_by_lamp(layer, luminaire, ray, distance) *
                                                 radiance_of(world_, luminaire, hit.position,
                                                             hit.side_towards(direction)));
        record(ledger, light, seen, layer.throughput, met_.empty() ? 1 : 0);
        met_.push_back({{distance, 0}, light});
        sum += seen;
        return passes;
    });
    if (met_.empty() && !ledger.lights.empty()) ++ledger.lights.back().rays;
    return sum;
}

/// Calls visit with the pdf of each point of the luminaire at that distance which may be sampled.
/// That of a searched luminaire is the direction's: all points on the ray are found by it.
template <class Visit>
void DirectLight::for_densities(LightIndex light, const LitLayer& layer, const Vec3& direction,
                                const Distance& there, const Visit& visit) {
    const Luminaire& luminaire = world_.lights.luminaires[light];
    if (const auto searched = SearchedLuminaire::of(luminaire)) {
        visit(searched->density(layer.vertex.position(), direction));
        return;
    }
    meetings_.clear();
    intersect(luminaire, receiver(layer.scatterer), direction, meetings_);
    for (const LightHit& meeting : meetings_)
        if (std::abs(meeting.distance - there.distance) <=
            same_point * there.distance + there.tolerance)
            visit(meeting.density);
}

/// Samples a direction either where the sky is bright or where the scatterer responds strongly. The
/// pdf is that of both ways together.
Vec3 DirectLight::from_sky(const LitLayer& layer, const Key& key, LightLedger& ledger) const {
    const SkyLight& sky = world_.sky.light;
    const Vertex& vertex = layer.vertex;
    const double u = uniform(key, Purpose::sky_choice);
    const Vec2 place{uniform(key, Purpose::sky_u), uniform(key, Purpose::sky_v)};
    const auto direction =
        u < 0.5 ? std::optional(sky.draw(place).direction) : layer.scatterer.sample(place);
    const Vec3 answer = direction ? answer_to(layer, *direction, key) : Vec3(0);
    if (answer == Vec3(0)) return Vec3(0);
    ++ledger.shadow;
    const Vec3 passed = light_left(layer, {vertex.position(), *direction}, far_away, false);
    if (passed == Vec3(0)) return Vec3(0);
    const double density = 0.5 * (sky.density(*direction) + layer.scatterer.pdf(*direction));
    return answer * gathered(layer, passed * world_.sky_radiance(*direction)) / (pi * density);
}

// POV-Ray's light sources: all of them are sampled, or some of many.

Vec3 DirectLight::from_sources(const LitLayer& layer, const Key& key, LightLedger& ledger) {
    Vec3 sum(0);
    for (const SourceSet& set : world_.lights.source_sets) {
        if (!world_.reaches(set.group, *layer.vertex.material)) continue;
        if (set.drawn())
            sum += from_drawn_sources(set, layer, key, ledger);
        else
            for (const std::uint32_t light : set.lights)
                sum += from_source(light, 1, layer, key, ledger);
    }
    return sum;
}

Vec3 DirectLight::from_source(std::uint32_t light, double weight, const LitLayer& layer,
                              const Key& key, LightLedger& ledger) {
    const std::uint64_t before = ledger.shadow;
    const Vec3 seen = weight * source_light(world_, light, layer, key, ledger);
    if (ledger.lights.empty()) return seen;
    LightCount& own = ledger.lights[world_.provenance.statement_of_light[light]];
    own.light.add(grey(seen));
    own.seen += layer.throughput * seen;
    own.rays += ledger.shadow - before;
    return seen;
}

/// Samples some of many sources. Sources have no surface that a sampled direction could hit.
Vec3 DirectLight::from_drawn_sources(const SourceSet& set, const LitLayer& layer, const Key& key,
                                     LightLedger& ledger) {
    const Key own = key.branched(Branch::drawn_sources);
    const Receiver point = set.asked(receiver(layer.scatterer));
    const BsdfLobes lobes = layer.scatterer.lobes();
    const auto look = [&](const Ray& ray, double tolerance) {
        return sight_past_clear(ray, tolerance);
    };
    const LightProbe scene(look);
    const auto ask = [&](const auto& strategy) {
        const auto answer = strategy.at({point, lobes, nullptr, set.parallel ? nullptr : &scene});
        Vec3 sum(0);
        for (int i = 0; i < shadow_rays_.usual; ++i) {
            const Key part = own.part(shadow_rays_.usual, i);
            samples_.clear();
            answer.sample(part, samples_);
            for (const LightPick& pick : samples_.picks)
                sum += from_source(set.lights[pick.light], 1 / (pick.expected * shadow_rays_.usual),
                                   layer, part, ledger);
        }
        return sum;
    };
    return std::visit(ask, set.sampler);
}

/// Returns the first hit on a ray at a surface that stops all light.
std::optional<ProbeHit> DirectLight::sight_past_clear(const Ray& ray, double tolerance) const {
    std::optional<ProbeHit> seen;
    world_.along(ray, tolerance, RayKind::light, [&](const Hit& hit, double distance) {
        if (!world_.material(hit.primitive).stops_light()) return true;
        seen = ProbeHit{distance, hit.normal, hit.tolerance, {}, 0};
        return false;
    });
    return seen;
}

}  // namespace candelabra
