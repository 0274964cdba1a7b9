// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/chosen_light.h"

#include "base/elementary.h"
#include "base/gamma.h"
#include "base/order.h"
#include "lighting/draw.h"
#include "transport/sight.h"
#include "transport/sky_at_layer.h"
#include "transport/source_light.h"
#include "world/radiance.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <span>
#include <utility>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Maximum number of shadow rays at one hit, where the number varies: this one, or that multiple of
/// the usual number.
constexpr int max_rays = 32, max_times_usual = 8;

/// Standard deviation that Russian roulette of luminaires may add to a sample with other light, in
/// steps of an 8-bit picture.
constexpr double hidden_steps = 4;
/// Minimum probability that luminaires are sampled.
constexpr double min_chance = 1.0 / 256;

/// About the greatest response of a surface, to compare its noise with that of others.
Rgb straight_response(const LitLayer& layer, const Key& key) {
    const Bsdf& bsdf = layer.scatterer.bsdf();
    BsdfTerms terms = layer.terms();
    terms.through_surface = true;
    return bsdf.evaluate(receiver(bsdf.shading()).normal, terms, layer.grain(key)) +
           Rgb(bsdf.highlights());
}

/// Difference in radiance that amounts to hidden_steps steps of the displayed picture.
double visible_step(double radiance) {
    constexpr double gamma = display_gamma, steps = 255;
    return hidden_steps / steps * gamma * math::pow(std::fmin(radiance, 1), 1 - 1 / gamma);
}

/// Probability of sampling luminaires (Russian roulette), which is low where their light, by the
/// estimate of the cell, is small against the light from before. The resulting noise is too small
/// to be seen.
double chance_of_asking(const LightEstimate::ShadowRay& expected, const LitLayer& layer,
                        const Rgb& straight, const Rgb& before) {
    const double share = std::abs(grey(layer.throughput)), there = share * grey(before);
    if (!(there > 0)) return 1;
    const double response = share * std::abs(grey(straight)) / pi;
    // In visible steps, because squares of what little is left of a path may be too small for a
    // number.
    const double unit = response / visible_step(there);
    const double mean = unit * expected.irradiance, deviation = unit * expected.noise;
    return std::clamp((mean * mean + deviation * deviation) / (mean * mean + 1), min_chance, 1.0);
}

}  // namespace

/// Number of shadow rays in proportion to the expected noise; a power of two, which suits Sobol
/// points.
int ChosenLight::rays_at(double noise_of_ray, const ArrivingLight& at, const Rgb& straight) const {
    const double noise = noise_of_ray * std::abs(grey(at.layer.throughput * straight));
    at.ledger.noise.add(noise);
    if (rays_.usual_noise == 0) return rays_.usual;
    const double wanted = rays_.usual * noise / rays_.usual_noise;
    const double most = std::max(max_rays, max_times_usual * rays_.usual);
    const double exponent = std::round(math::log2(std::clamp<double>(wanted, 1, most)));
    return 1 << static_cast<int>(exponent);
}

LightKinds ChosenLight::kinds_at(const LitLayer& layer) const {
    LightKinds kinds = layer.light.without({LightKind::sources});
    const SourceSet* joined = shot_.joined;
    if (!joined || !world_.reaches(joined->group, *layer.vertex.material))
        kinds = kinds.without({LightKind::drawn_sources});
    // Where no lamps count, the sky has samples of its own.
    if (world_.sky.light.empty() ||
        !kinds.has_any({LightKind::luminaires, LightKind::drawn_sources}))
        kinds = kinds.without({LightKind::sky});
    return world_.lights.any_glowing() ? kinds : kinds.without({LightKind::luminaires});
}

ChosenLight::Found ChosenLight::operator()(const ArrivingLight& at, const Key& key,
                                           LightKinds kinds, const Rgb& before) {
    const LitLayer& layer = at.layer;
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
            const auto answer =
                strategy.at({point, lobes, &sampler, &scene, kinds.has(LightKind::sky)});
            Found found{Rgb(0), answer.takes_sky()};
            const LightKinds chosen = found.with_sky ? kinds : kinds.without({LightKind::sky});
            int count = rays_.usual;
            double chance = 1;
            const std::optional<LightEstimate> estimate = answer.estimate();
            const auto expected = estimate ? estimate->ray : std::nullopt;
            if (expected && scatterer.in_air()) {
                count = rays_at(expected->noise, at, scatterer.phase().mean());
            } else if (expected) {
                const Rgb straight =
                    estimate->response ? Rgb(*estimate->response) : straight_response(layer, key);
                chance = chance_of_asking(*expected, layer, straight, before);
                if (chance < 1 && uniform(key, Purpose::light_roulette) >= chance) return found;
                count = rays_at(expected->noise, at, straight);
            }
            constexpr bool together = SamplesTogether<decltype(answer)>;
            constexpr int most = together ? static_cast<int>(draws_together) : 1;
            for (int first = 0; first < count; first += most) {
                const int some = std::min(most, count - first);
                std::array<Key, draws_together> keys;
                for (int i = 0; i < some; ++i) {
                    keys[i] = key.part(count, first + i);
                    samples_[i].clear();
                }
                if constexpr (together) {
                    answer.sample(std::span(keys).first(some), std::span(samples_).first(some));
                    for (int i = 0; i < some; ++i)
                        for (const LightPick& pick : samples_[i].picks)
                            world_.lights.luminaires.fetch(pick.light);
                } else {
                    answer.sample(keys[0], samples_[0]);
                }
                for (int i = 0; i < some; ++i)
                    found.radiance +=
                        by_answer(answer, samples_[i], {at, keys[i], count * chance, chosen});
            }
            return found;
        },
        shot_.sampler);
}

std::optional<double> ChosenLight::expected(const Vec3& position) const {
    const Receiver point{position, Vec3(0), Horizon::none};
    const auto look = [&](const Ray& ray, double tolerance) {
        return first_sight(world_, ray, tolerance);
    };
    const LightProbe scene(look);
    const BsdfLobes lobes;
    const auto estimate = std::visit(
        [&](const auto& strategy) {
            return strategy.at({point, lobes, nullptr, &scene, !world_.sky.light.empty()})
                .estimate();
        },
        shot_.sampler);
    return estimate ? std::optional(estimate->light) : std::nullopt;
}

/// Light by one shadow ray.
template <LightAnswer Answer>
Rgb ChosenLight::by_answer(const Answer& answer, const LightSamples& samples, const Asked& asked) {
    Rgb sum(0);
    if (samples.direction)
        sum += by_direction(samples, asked, [&](LightIndex light, double of_point) {
            return answer.pdf(*samples.direction, answer.expected(asked.key, light), of_point);
        });
    // The conventional strategy picks every luminaire once; further shadow rays add points on each.
    const bool several = samples.picks.size() > 1;
    for (const LightPick& pick : samples.picks) {
        if (pick.light == sky_light) {
            sum += from_sky(asked, [&](const Vec3& direction, double of_direction) {
                return answer.pdf(direction, pick.expected, of_direction);
            });
            continue;
        }
        const Lamp lamp = shot_.lamp(pick.light);
        if (lamp.is_source()) {
            // No direction hits a source.
            if (asked.kinds.has(LightKind::drawn_sources))
                sum += light_of_source(lamp.index(), 1 / (pick.expected * asked.number), asked.at,
                                       asked.key);
            continue;
        }
        if (!asked.kinds.has(LightKind::luminaires)) continue;
        const Key place = several ? asked.key.with_branch(pick.light) : asked.key;
        sum += world_.lights.visit(pick.light, [&](const auto& glowing) {
            return by_pick(glowing, pick, asked, place,
                           [&](const Vec3& direction, double of_point) {
                               return answer.pdf(direction, pick.expected, of_point);
                           });
        });
    }
    return sum;
}

/// Light of one luminaire. Density: returns the pdf of a sampled point, given its direction and the
/// luminaire's own pdf. A searched luminaire is met wherever the ray meets it.
template <class Density>
Rgb ChosenLight::by_pick(const Luminaire& luminaire, const LightPick& pick, const Asked& asked,
                         const Key& place, const Density& density) {
    const LitLayer& layer = asked.at.layer;
    const auto searched = SearchedLuminaire::of(luminaire);
    Vec3 direction(0);
    double of_point = 0;
    on_ray_.clear();
    if (searched) {
        const auto drawn = searched->draw(layer.vertex.position(), place_on_light(place));
        if (!drawn) return Rgb(0);
        direction = drawn->direction;
        of_point = drawn->density;
    } else {
        const auto point = sample(luminaire, receiver(layer.scatterer), place_on_light(place));
        if (!point) return Rgb(0);
        direction = point->direction;
        of_point = point->density;
        on_ray_.push_back({pick.light, point->distance});
    }
    const Rgb response = layer.response(direction, place);
    if (response == Rgb(0)) return Rgb(0);
    const ShadowRay ray(asked.at, direction, asked.key);
    if (searched) walk_along(ray, asked);
    const Rgb weight = response / (pi * density(direction, of_point) * asked.number);
    return seen(ray, asked.at,
                [&](const OnRay& there) { return there.light == pick.light ? weight : Rgb(0); });
}

/// Light of a box of media, which no direction meets.
template <class Density>
Rgb ChosenLight::by_pick(const MediaBox& box, const LightPick& pick, const Asked& asked,
                         const Key& place, const Density&) const {
    const LitLayer& layer = asked.at.layer;
    const auto point = sample(box, receiver(layer.scatterer), place_on_light(place));
    if (!point) return Rgb(0);
    const Rgb response = layer.response(point->direction, place);
    if (response == Rgb(0)) return Rgb(0);
    const ShadowRay ray(asked.at, point->direction, asked.key);
    ++asked.at.ledger.shadow;
    const Rgb left = ray.left(point->distance);
    const Rgb weight = response / (pi * (pick.expected * point->density) * asked.number);
    if (left == Rgb(0)) return asked.at({Lamp::luminaire(pick.light), left, Rgb(0), 1});
    return asked.at(
        {Lamp::luminaire(pick.light), weight, left * ray.emitted(box, point->distance), 1});
}

/// Light of the sky where it is picked. Density: returns the pdf of a direction, given that of
/// SkyAtLayer.
template <class Density>
Rgb ChosenLight::from_sky(const Asked& asked, const Density& density) const {
    const SkyAtLayer sky(asked.at, asked.key);
    const auto direction = sky.draw();
    const Rgb response = direction ? asked.at.layer.response(*direction, asked.key) : Rgb(0);
    if (response == Rgb(0)) return Rgb(0);
    return sky.from(*direction,
                    response / (pi * density(*direction, sky.density(*direction)) * asked.number));
}

/// Light of all luminaires that are visible in the direction, and of the sky behind them if it is
/// among what is chosen. Density: returns the pdf of a point,
/// given its luminaire and the luminaire's own pdf.
template <class Density>
Rgb ChosenLight::by_direction(const LightSamples& samples, const Asked& asked,
                              const Density& density) {
    const LitLayer& layer = asked.at.layer;
    const Vec3& direction = *samples.direction;
    if (!asked.kinds.has_any({LightKind::luminaires, LightKind::sky})) return Rgb(0);
    const Rgb response = layer.response(direction, asked.key);
    if (response == Rgb(0)) return Rgb(0);
    const auto weight = [&](LightIndex light, double of_point) {
        return response / (pi * density(light, of_point) * asked.number);
    };
    const ShadowRay ray(asked.at, direction, asked.key);
    if (samples.tree) {
        meet_along(*samples.tree, asked.at, direction);
        return seen(ray, asked.at,
                    [&](const OnRay& there) { return weight(there.light, there.density); });
    }
    const Walked walked = walk_along(ray, asked);
    Rgb sum = seen(ray, asked.at, [&](const OnRay& there) {
        Rgb of_lamp(0);
        for_densities(there, layer, direction,
                      [&](double of_point) { of_lamp += weight(there.light, of_point); });
        return of_lamp;
    });
    if (asked.kinds.has(LightKind::sky) && walked.open) {
        const SkyAtLayer sky(asked.at, asked.key);
        const Rgb left = walked.nothing ? Rgb(1) : ray.left_from_sky();
        sum += sky.from(direction, weight(sky_light, sky.density(direction)),
                        {left, on_ray_.empty() ? 1U : 0U});
    }
    return sum;
}

/// Radiance by the luminaires in on_ray_, as far as they are visible.
Rgb ChosenLight::seen(const ShadowRay& ray, const ArrivingLight& at, Weight weight) const {
    Rgb sum(0);
    for (const OnRay& there : on_ray_) {
        const LuminaireAt lamp = world_.lights.luminaires[there.light];
        const Luminaire& luminaire = *lamp;
        at.ledger.shadow += there.rays;
        const Rgb left = there.unobstructed ? Rgb(1) : ray.left(there.distance);
        const Rgb factor = left == Rgb(0) ? left : weight(there);
        Rgb light(0);
        if (factor != Rgb(0))
            light = left * (there.hit ? ray.emitted(luminaire, *there.hit, there.distance)
                                      : ray.emitted(luminaire, there.distance));
        sum += at({Lamp::luminaire(there.light), factor, light, there.rays});
        if (left == Rgb(0) || world_.material(luminaire.primitive).stops_light()) break;
    }
    return sum;
}

/// Fills on_ray_ with the luminaires that a ray in the scene meets, up to a surface that stops it.
ChosenLight::Walked ChosenLight::walk_along(const ShadowRay& ray, const Asked& asked) {
    on_ray_.clear();
    bool unobstructed = !world_.facts.dims_between, open = true;
    const bool counted = asked.kinds.has(LightKind::luminaires);
    world_.along(
        ray.ray(), asked.at.layer.vertex.tolerance(), RayKind::light,
        [&](const Hit& hit, double distance) {
            const bool first = std::exchange(unobstructed, false);
            const LightIndex light = counted ? world_.luminaire_of(hit.primitive) : no_primitive;
            // The walk is one ray, whatever it meets.
            if (light != no_primitive)
                on_ray_.push_back({light, distance, 0, hit, first, on_ray_.empty() ? 1U : 0U});
            open = !world_.material(hit.primitive).stops_light();
            return open;
        });
    const Walked walked{open, unobstructed};
    if (!on_ray_.empty()) return walked;
    ++asked.at.ledger.shadow;
    if (!asked.kinds.has(LightKind::sky) || !open) asked.at.ledger.add_miss();
    return walked;
}

/// Adds the meetings of a searched luminaire behind the first one, which is seen through: the
/// direction is drawn for all of them.
void ChosenLight::add_further(const Luminaire& luminaire, const Ray& ray, LightHits& meetings) {
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
    const auto same_place = [](const LightHit& a, const LightHit& b) {
        return b.distance - a.distance <= same_point * b.distance;
    };
    meetings.erase(std::unique(meetings.begin(), meetings.end(), same_place), meetings.end());
}

/// Fills on_ray_ with all luminaires on a line, by the tree of luminaires.
void ChosenLight::meet_along(const LightTree& tree, const ArrivingLight& at,
                             const Vec3& direction) {
    on_ray_.clear();
    const Receiver point = receiver(at.layer.scatterer);
    tree.along(point.position, direction, [&](LightIndex light) {
        if (light >= world_.lights.luminaires.size()) return;  // no line meets media
        hits_.clear();
        const LuminaireAt lamp = world_.lights.luminaires[light];
        const Luminaire& luminaire = *lamp;
        intersect(luminaire, point, direction, hits_);
        if (!hits_.empty() && !world_.material(luminaire.primitive).stops_light())
            add_further(luminaire, {point.position, direction}, hits_);
        for (const LightHit& met : hits_)
            // The point may lie on a luminaire, which does not light itself there.
            if (met.distance > at.layer.vertex.tolerance())
                on_ray_.push_back({light, met.distance, met.density});
    });
    sort_stably(on_ray_, [](const OnRay& a, const OnRay& b) {
        return std::pair(a.distance, a.light) < std::pair(b.distance, b.light);
    });
}

/// Calls visit with the pdf of each point of the luminaire at that distance which may be sampled.
/// That of a searched luminaire is the direction's: all points on the ray are found by it.
template <class Visit>
void ChosenLight::for_densities(const OnRay& there, const LitLayer& layer, const Vec3& direction,
                                const Visit& visit) {
    const LuminaireAt lamp = world_.lights.luminaires[there.light];
    const Luminaire& luminaire = *lamp;
    if (const auto searched = SearchedLuminaire::of(luminaire)) {
        visit(searched->density(layer.vertex.position(), direction));
        return;
    }
    hits_.clear();
    intersect(luminaire, receiver(layer.scatterer), direction, hits_);
    for (const LightHit& met : hits_)
        if (std::abs(met.distance - there.distance) <=
            same_point * there.distance + there.hit->tolerance)
            visit(met.density);
}

}  // namespace candelabra
