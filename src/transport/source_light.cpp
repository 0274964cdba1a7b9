// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/source_light.h"

#include "transport/shadow_ray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

/// Whether each light of the grid is evaluated by itself, not only its shadow.
bool lit_by_grid(const PointLight& light, const Scatterer& scatterer) {
    return light.is_area() && light.area_illumination && !scatterer.in_air();
}

/// Returns one of `count` places in a row, as likely as it weighs in a mean whose parts are halved
/// down to their ends.
int in_halves(int count, double random) {
    int first = 0, last = count - 1;
    while (first < last) {
        random *= 2;
        if (random >= 1)
            first = (first + last + 1) / 2;
        else
            last = (first + last) / 2;
        random -= std::floor(random);
    }
    return first;
}

/// Light of one source at a layer, with the data to evaluate it.
class SourceAtLayer {
public:
    SourceAtLayer(const PointLight& light, std::uint32_t number, const ArrivingLight& at,
                  const Key& key)
        : at_(at),
          light_(light),
          window_(at.world.lights.reach[number].window.get()),
          rules_(rules_of(at.world, light, number)),
          scatterer_(at.layer.scatterer),
          terms_{.highlights = at.layer.highlights && !light.shadowless,
                 .through_surface = passes_surfaces(at.world)},
          grain_(at.layer.grain(key)),
          key_(key) {
        // As in POV-Ray: with area_illumination the grid decides which side it lights, and without
        // a grid both sides are lit.
        if (light.area_illumination && light.size1 == 0 && !scatterer_.in_air())
            scatterer_ = both_sides_.emplace(scatterer_.bsdf().on_both_sides());
    }
    SourceAtLayer(const SourceAtLayer&) = delete;

    /// The layer's response to the source's light. `central` is the light from its location.
    Rgb response(const Incidence& central) {
        direction_ = central.direction;
        return lit_by_grid(light_, scatterer_) ? grid_answer() : answer_to(central);
    }
    /// Fraction of the light that is left at the layer. Precondition: response() was called.
    Rgb left(const Incidence& central) {
        if (light_.shadowless) return Rgb(window_ && !seen_through(central) ? 0 : 1);
        if (!light_.is_area()) return passed(central);
        return at_.layer.samples_grids ? sampled_grid_shadow() : grid_shadow();
    }

private:
    Rgb answer_to(const Incidence& light) const {
        if (light.colour == Rgb(0)) return Rgb(0);
        if (scatterer_.in_air()) return light.colour * scatterer_.phase().evaluate(direction_);
        const Bsdf& bsdf = scatterer_.bsdf();
        // The film's iridescence depends on the direction to the light's centre.
        return light.colour * bsdf.film(direction_) *
               bsdf.evaluate_without_film(light.direction, terms_, grain_);
    }

    Rgb grid_answer() const {
        Rgb sum(0);
        for (int i = 0; i < light_.size1; ++i)
            for (int j = 0; j < light_.size2; ++j)
                sum += answer_to(
                    incidence(light_, grid_point(light_, i, j, direction_), vertex().position()));
        return sum / static_cast<double>(light_.size1 * light_.size2);
    }

    Rgb passed(const Incidence& light) {
        if (light.distance <= 0) return Rgb(1);
        const auto until = window_ ? seen_through(light) : std::optional(light.distance);
        if (!until) return Rgb(0);
        ++at_.ledger.shadow;
        return ShadowRay(at_, light.direction, key_, rules_).left(*until);
    }

    static SourceRules rules_of(const World& world, const PointLight& light, std::uint32_t number) {
        // As in POV-Ray, the source says whether air outside of solids dims its light.
        const bool air = light.media_attenuation && light.media_interaction;
        return {air ? AirOnWay::throughout : AirOnWay::in_solids,
                world.photon_targets.empty() ? PhotonWays() : ways_of_source(world, number)};
    }

    const Vertex& vertex() const { return at_.layer.vertex; }

    /// Returns the distance to the window; nothing if the ray does not pass through it.
    std::optional<double> seen_through(const Incidence& light) const {
        const auto any = [](std::uint32_t) { return true; };
        const auto met = window_->first({vertex().position(), light.direction},
                                        {vertex().tolerance(), light.distance}, any);
        return met ? std::optional(met->t) : std::nullopt;
    }

    /// Fraction of the grid's light that arrives.
    Rgb grid_shadow() {
        corners_.assign(static_cast<std::size_t>(light_.size1 * light_.size2), Rgb(-1));
        return mean({0, 0, light_.size1 - 1, light_.size2 - 1}, 0);
    }

    /// Estimate of the same from one light of the grid.
    Rgb sampled_grid_shadow() {
        return shadow_of(in_halves(light_.size1, uniform(key_, Purpose::grid_u)),
                         in_halves(light_.size2, uniform(key_, Purpose::grid_v)));
    }

    struct Part {
        int first1, first2, last1, last2;
    };

    /// Mean over a part of the grid, by its corners; the part is divided if they differ. The
    /// weights of the parts are POV-Ray's.
    Rgb mean(const Part& p, int level) {
        const std::array<Rgb, 4> corner = {at(p.first1, p.first2), at(p.last1, p.first2),
                                           at(p.first1, p.last2), at(p.last1, p.last2)};
        const bool divisible = p.last1 - p.first1 > 1 || p.last2 - p.first2 > 1;
        if (!divisible || (light_.adaptive && level >= *light_.adaptive && alike(corner)))
            return 0.25 * (corner[0] + corner[1] + corner[2] + corner[3]);
        const int low1 = (p.first1 + p.last1) / 2, high1 = (p.first1 + p.last1 + 1) / 2;
        const int low2 = (p.first2 + p.last2) / 2, high2 = (p.first2 + p.last2 + 1) / 2;
        return 0.25 * (mean({p.first1, p.first2, low1, low2}, level + 1) +
                       mean({high1, p.first2, p.last1, low2}, level + 1) +
                       mean({p.first1, high2, low1, p.last2}, level + 1) +
                       mean({high1, high2, p.last1, p.last2}, level + 1));
    }

    bool alike(const std::array<Rgb, 4>& corner) const {
        const auto differ = [&](const Rgb& a, const Rgb& b) {
            const Rgb d = abs(a - b) * light_.colour;
            return d.r + d.g + d.b > 0.1;
        };
        return !differ(corner[0], corner[1]) && !differ(corner[2], corner[3]) &&
               !differ(corner[0], corner[2]) && !differ(corner[1], corner[3]);
    }

    /// Fraction of light that arrives from one light of the grid; computed once.
    Rgb at(int i, int j) {
        Rgb& known = corners_[static_cast<std::size_t>(i * light_.size2 + j)];
        return known.r >= 0 ? known : known = shadow_of(i, j);
    }

    Rgb shadow_of(int i, int j) {
        double place1 = i, place2 = j;
        if (light_.jitter) {
            const Key key = key_.with_branch(static_cast<std::uint32_t>(i * light_.size2 + j));
            place1 += uniform(key, Purpose::jitter_u) - 0.5;
            place2 += uniform(key, Purpose::jitter_v) - 0.5;
        }
        const Vec3 from = grid_point(light_, place1, place2, direction_);
        if (light_.along_axis()) return passed(incidence(light_, from, vertex().position()));
        const Vec3 offset = from - vertex().position();
        const double distance = length(offset);
        return distance == 0 ? Rgb(1) : passed({offset / distance, distance, Rgb(1)});
    }

    const ArrivingLight& at_;
    const PointLight& light_;
    const Composite* window_;  ///< null: none
    const SourceRules rules_;
    Scatterer scatterer_;
    std::optional<Bsdf> both_sides_;  ///< referred to by scatterer_, if present
    const BsdfTerms terms_;
    const double grain_;
    const Key key_;
    Vec3 direction_ = Vec3(0);
    std::vector<Rgb> corners_;
};

/// Returns the first hit on a ray at a surface that stops all light.
std::optional<ProbeHit> sight_past_clear(const World& world, const Ray& ray, double tolerance) {
    std::optional<ProbeHit> seen;
    world.along(ray, tolerance, RayKind::light, [&](const Hit& hit, double distance) {
        if (!world.material(hit.primitive).stops_light()) return true;
        seen = ProbeHit{distance, hit.normal, hit.tolerance, {}, 0};
        return false;
    });
    return seen;
}

}  // namespace

Rgb SourceLight::operator()(const ArrivingLight& at, const Key& key) {
    Rgb sum(0);
    for (std::size_t i = 0; i < samplers_.size(); ++i) {
        const SourceSet& set = at.world.lights.source_sets[i];
        const LightKind kind = set.drawn() ? LightKind::drawn_sources : LightKind::sources;
        if (&set == joined_ || !at.layer.light.has(kind) ||
            !at.world.reaches(set.group, *at.layer.vertex.material))
            continue;
        if (set.drawn())
            sum += drawn(set, samplers_[i], at, key);
        else
            for (const std::uint32_t light : set.lights) sum += light_of_source(light, 1, at, key);
    }
    return sum;
}

Rgb light_of_source(std::uint32_t number, double weight, const ArrivingLight& at, const Key& key) {
    const bool in_air = at.layer.scatterer.in_air();
    const Vec3& position = at.layer.vertex.position();
    const PointLight& light = at.world.lights.sources[number];
    if (in_air && (light.shadowless || !light.media_interaction)) return Rgb(0);
    const bool by_grid = lit_by_grid(light, at.layer.scatterer);
    if (!by_grid && is_beside_cone(light, position)) return Rgb(0);
    Incidence central = incidence(light, light.location, position);
    if (!by_grid && central.colour == Rgb(0)) return Rgb(0);
    const Key own = key.branched(Branch::source, number);
    if (light.disc_edge < 1)
        central.direction =
            turned_from(central.direction, 1 - uniform(own, Purpose::sun_u) * (1 - light.disc_edge),
                        2 * std::numbers::pi * uniform(own, Purpose::sun_v));
    SourceAtLayer source(light, number, at, own);
    const Rgb response = source.response(central);
    if (response == Rgb(0)) return Rgb(0);
    const std::uint64_t before = at.ledger.shadow;
    const Rgb left = source.left(central);
    return at({Lamp::source(number), weight * response, left, at.ledger.shadow - before});
}

/// Samples some of many sources. Sources have no surface that a sampled direction could hit.
Rgb SourceLight::drawn(const SourceSet& set, const BuiltLightSampler& sampler,
                       const ArrivingLight& at, const Key& key) {
    const Key own = key.branched(Branch::drawn_sources);
    const Receiver point = set.asked(receiver(at.layer.scatterer));
    const BsdfLobes lobes = at.layer.scatterer.lobes();
    const auto look = [&](const Ray& ray, double tolerance) {
        return sight_past_clear(at.world, ray, tolerance);
    };
    const LightProbe scene(look);
    const auto ask = [&](const auto& strategy) {
        const auto answer = strategy.at({point, lobes, nullptr, set.parallel ? nullptr : &scene});
        Rgb sum(0);
        for (int i = 0; i < rays_; ++i) {
            const Key part = own.part(rays_, i);
            samples_.clear();
            answer.sample(part, samples_);
            for (const LightPick& pick : samples_.picks)
                sum +=
                    light_of_source(set.lights[pick.light], 1 / (pick.expected * rays_), at, part);
        }
        return sum;
    };
    return std::visit(ask, sampler);
}

}  // namespace candelabra
