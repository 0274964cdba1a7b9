// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/point_lights.h"

#include "transport/light_left.h"

#include <algorithm>
#include <array>

namespace candelabra {

namespace {

/// As in POV-Ray, a clear surface does not count if it lies no further than this, along the way of
/// light, behind another one that counts, or from either end. So glasses that touch each other, and
/// things in a glass, are not darker for it.
constexpr double apart_for_light = 1e-3;

/// Whether each light of the grid is evaluated by itself, not only its shadow.
bool lit_by_grid(const PointLight& light, const Scatterer& scatterer) {
    return light.is_area() && light.area_illumination && !scatterer.in_air();
}

/// Light of one source at a point, with the data to evaluate it.
class SourceLight {
public:
    SourceLight(const World& world, const PointLight& light, std::uint32_t number,
                const LitLayer& layer, const Key& key, LightLedger& ledger)
        : world_(world),
          light_(light),
          window_(world.lights.reach[number].window.get()),
          photons_(world.photon_targets.empty() ? PhotonWays() : ways_of_source(world, number)),
          collects_(!world.photon_targets.empty() && layer.collects()),
          vertex_(layer.vertex),
          scatterer_(layer.scatterer),
          terms_{.highlights = layer.highlights && !light.shadowless,
                 .through_surface = passes_surfaces(world)},
          grain_(layer.grain(key)),
          key_(key),
          ledger_(ledger) {
        // As in POV-Ray: with area_illumination the grid decides which side it lights, and without
        // a grid both sides are lit.
        if (light.area_illumination && light.size1 == 0 && !scatterer_.in_air())
            scatterer_ = both_sides_.emplace(scatterer_.bsdf().on_both_sides());
    }
    SourceLight(const SourceLight&) = delete;

    /// `central` is the light from its location.
    Vec3 seen(const Incidence& central) {
        direction_ = central.direction;
        const Vec3 answer = lit_by_grid(light_, scatterer_) ? grid_answer() : answer_to(central);
        if (answer == Vec3(0)) return answer;
        if (light_.shadowless) return window_ && !seen_through(central) ? Vec3(0) : answer;
        return answer * (light_.is_area() ? grid_shadow() : passed(central));
    }

private:
    Vec3 answer_to(const Incidence& light) const {
        if (light.colour == Vec3(0)) return Vec3(0);
        if (scatterer_.in_air()) return light.colour * scatterer_.phase().evaluate(direction_);
        const Bsdf& bsdf = scatterer_.bsdf();
        // The film's iridescence depends on the direction to the light's centre.
        return light.colour * bsdf.film(direction_) *
               bsdf.evaluate_without_film(light.direction, terms_, grain_);
    }

    Vec3 grid_answer() const {
        Vec3 sum(0);
        for (int i = 0; i < light_.size1; ++i)
            for (int j = 0; j < light_.size2; ++j)
                sum += answer_to(
                    incidence(light_, grid_point(light_, i, j, direction_), vertex_.position()));
        return sum / static_cast<double>(light_.size1 * light_.size2);
    }

    Vec3 passed(const Incidence& light) {
        if (light.distance <= 0) return Vec3(1);
        const auto until = window_ ? seen_through(light) : std::optional(light.distance);
        if (!until) return Vec3(0);
        ++ledger_.shadow;
        const Ray ray{vertex_.position(), light.direction};
        // As in POV-Ray, the source says whether air outside of solids dims its light.
        const bool air = light_.media_attenuation && light_.media_interaction;
        const Vec3 left = light_left(world_,
                                     {.ray = ray,
                                      .tolerance = vertex_.tolerance(),
                                      .distance = *until,
                                      .around = vertex_.around,
                                      .apart = apart_for_light,
                                      .air = air ? AirOnWay::throughout : AirOnWay::in_solids},
                                     key_);
        return left != Vec3(0) && brought(ray, *until) ? Vec3(0) : left;
    }

    /// Whether photons bring the light along that ray instead.
    bool brought(const Ray& ray, double until) const {
        return collects_ && target_between(world_, photons_, ray, vertex_.tolerance(), until);
    }

    /// Returns the distance to the window; nothing if the ray does not pass through it.
    std::optional<double> seen_through(const Incidence& light) const {
        const auto any = [](std::uint32_t) { return true; };
        const auto met = window_->first({vertex_.position(), light.direction},
                                        {vertex_.tolerance(), light.distance}, any);
        return met ? std::optional(met->t) : std::nullopt;
    }

    /// Fraction of the grid's light that arrives.
    Vec3 grid_shadow() {
        corners_.assign(static_cast<std::size_t>(light_.size1 * light_.size2), Vec3(-1));
        return mean({0, 0, light_.size1 - 1, light_.size2 - 1}, 0);
    }

    struct Part {
        int first1, first2, last1, last2;
    };

    /// Mean over a part of the grid, by its corners; the part is divided if they differ. The
    /// weights of the parts are POV-Ray's.
    Vec3 mean(const Part& p, int level) {
        const std::array<Vec3, 4> corner = {at(p.first1, p.first2), at(p.last1, p.first2),
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

    bool alike(const std::array<Vec3, 4>& corner) const {
        const auto differ = [&](const Vec3& a, const Vec3& b) {
            const Vec3 d = glm::abs(a - b) * light_.colour;
            return d.x + d.y + d.z > 0.1;
        };
        return !differ(corner[0], corner[1]) && !differ(corner[2], corner[3]) &&
               !differ(corner[0], corner[2]) && !differ(corner[1], corner[3]);
    }

    /// Fraction of light that arrives from one light of the grid; computed once.
    Vec3 at(int i, int j) {
        const int index = i * light_.size2 + j;
        Vec3& known = corners_[static_cast<std::size_t>(index)];
        if (known.x >= 0) return known;
        double place1 = i, place2 = j;
        if (light_.jitter) {
            const Key key = key_.with_branch(static_cast<std::uint32_t>(index));
            place1 += uniform(key, Purpose::jitter_u) - 0.5;
            place2 += uniform(key, Purpose::jitter_v) - 0.5;
        }
        const Vec3 from = grid_point(light_, place1, place2, direction_);
        if (light_.along_axis()) return known = passed(incidence(light_, from, vertex_.position()));
        const Vec3 offset = from - vertex_.position();
        const double distance = length(offset);
        return known = distance == 0 ? Vec3(1) : passed({offset / distance, distance, Vec3(1)});
    }

    const World& world_;
    const PointLight& light_;
    const Composite* window_;  ///< null: none
    const PhotonWays photons_;
    const bool collects_;  ///< the layer shows light of photons
    const Vertex& vertex_;
    Scatterer scatterer_;
    std::optional<Bsdf> both_sides_;  ///< referred to by scatterer_, if present
    const BsdfTerms terms_;
    const double grain_;
    const Key key_;
    LightLedger& ledger_;
    Vec3 direction_ = Vec3(0);
    std::vector<Vec3> corners_;
};

}  // namespace

Vec3 source_light(const World& world, std::uint32_t light, const LitLayer& layer, const Key& key,
                  LightLedger& ledger) {
    const bool in_air = layer.scatterer.in_air();
    return std::visit(
        [&](const auto& l) {
            if (in_air && (l.shadowless || !l.media_interaction)) return Vec3(0);
            const bool by_grid = lit_by_grid(l, layer.scatterer);
            if (!by_grid && is_beside_cone(l, layer.vertex.position())) return Vec3(0);
            const Incidence central = incidence(l, l.location, layer.vertex.position());
            if (!by_grid && central.colour == Vec3(0)) return Vec3(0);
            const Key own = key.branched(Branch::source, light);
            return SourceLight(world, l, light, layer, own, ledger).seen(central);
        },
        world.lights.sources[light]);
}

}  // namespace candelabra
