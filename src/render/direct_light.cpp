// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/direct_light.h"

#include "render/microfacet.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace {

using std::numbers::pi;

/// Behind all objects.
constexpr double far_away = 1e20;

/// Light of one source at a point, with what it needs.
class SourceLight {
public:
    SourceLight(const World& world, const PointLight& light, const Composite* window,
                const Shading& s, const Key& key, RayCounts& rays)
        : world_(world), light_(light), window_(window), s_(s), key_(key), rays_(rays) {}

    Vec3 seen() {
        const Incidence central = incidence(light_, light_.location, s_.position);
        direction_ = central.direction;
        const Vec3 answer =
            light_.is_area() && light_.area_illumination ? grid_answer() : answer_to(central);
        if (answer == Vec3(0)) return answer;
        if (light_.shadowless) return window_ && !seen_through(central) ? Vec3(0) : answer;
        return answer * (light_.is_area() ? grid_shadow() : passed(central));
    }

private:
    Vec3 answer_to(const Incidence& light) const {
        if (light.colour == Vec3(0)) return Vec3(0);
        const double grain = s_.finish->crand == 0 ? 0 : uniform(key_, Purpose::grain);
        const Vec3 answer = s_.finish->microfacet.on
                                ? facet_response(s_, light.direction, Lobes::all)
                                : response(s_, light.direction, !light_.shadowless, grain);
        return answer * light.colour * iridescence(world_, s_, light.direction);
    }

    Vec3 grid_answer() const {
        Vec3 sum(0);
        for (int i = 0; i < light_.size1; ++i)
            for (int j = 0; j < light_.size2; ++j)
                sum +=
                    answer_to(incidence(light_, grid_point(light_, i, j, direction_), s_.position));
        return sum / static_cast<double>(light_.size1 * light_.size2);
    }

    Vec3 passed(const Incidence& light) {
        if (light.distance <= 0) return Vec3(1);
        const auto until = window_ ? seen_through(light) : std::optional(light.distance);
        if (!until) return Vec3(0);
        ++rays_.shadow;
        return world_.transmittance({s_.position, light.direction}, s_.tolerance, *until);
    }

    /// The way to the window, which may not be there in this direction.
    std::optional<double> seen_through(const Incidence& light) const {
        const auto any = [](std::uint32_t) { return true; };
        const auto met =
            window_->first({s_.position, light.direction}, {s_.tolerance, light.distance}, any);
        return met ? std::optional(met->t) : std::nullopt;
    }

    /// The share of light that arrives from the whole grid.
    Vec3 grid_shadow() {
        corners_.assign(static_cast<std::size_t>(light_.size1 * light_.size2), Vec3(-1));
        return mean({0, 0, light_.size1 - 1, light_.size2 - 1}, 0);
    }

    struct Part {
        int first1, first2, last1, last2;
    };

    /// The mean over a part of the grid, from its corners; divided where they differ. The parts'
    /// weights are POV-Ray's.
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

    /// The share of light from one light of the grid; asked once.
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
        const Vec3 offset = grid_point(light_, place1, place2, direction_) - s_.position;
        const double distance = length(offset);
        return known = distance == 0 ? Vec3(1) : passed({offset / distance, distance, Vec3(1)});
    }

    const World& world_;
    const PointLight& light_;
    const Composite* window_;  ///< null: none
    const Shading& s_;
    const Key key_;
    RayCounts& rays_;
    Vec3 direction_ = Vec3(0);
    std::vector<Vec3> corners_;
};

ShadingPoint point_of(const Shading& s) {
    return {s.position, s.normal, s.both_sides || s.finish->diffuse_back != 0};
}

/// What the surface sends on of light from there.
Vec3 answer_to(const World& world, const Shading& s, const Vec3& direction, const Key& key) {
    if (s.finish->microfacet.on) return facet_response(s, direction, Lobes::wide);
    const double grain = s.finish->crand == 0 ? 0 : uniform(key, Purpose::grain);
    return response(s, direction, true, grain) * iridescence(world, s, direction);
}

Vec2 place_on_light(const Key& key) {
    return {uniform(key, Purpose::light_u), uniform(key, Purpose::light_v)};
}

}  // namespace

Vec3 DirectLight::from_sources(const Shading& s, const Key& key, RayCounts& rays) const {
    Vec3 sum(0);
    for (std::size_t i = 0; i < world_.lights.size(); ++i) {
        if (!world_.reaches(i, *s.material)) continue;
        const auto number = static_cast<std::uint32_t>(i) + 1;
        const Key own = Key{key.pixel, key.sample, key.path * 31u + 7u * number, 0};
        const Composite* window = world_.light_reach[i].window.get();
        sum += std::visit(
            [&](const auto& l) { return SourceLight(world_, l, window, s, own, rays).seen(); },
            world_.lights[i]);
    }
    return sum;
}

Vec3 DirectLight::radiance(const Luminaire& luminaire, const Vec3& position) const {
    return luminaire.varying ? world_.emission(luminaire.primitive, position) : luminaire.radiance;
}

/// The density of a drawn point, per steradian, is for the caller to say.
template <class Density>
Vec3 DirectLight::from_luminaire(const Shading& s, const LightPick& pick, const Key& key,
                                 RayCounts& rays, const Density& density) const {
    const Luminaire& luminaire = world_.luminaires[pick.light];
    const auto point = sample(luminaire, point_of(s), place_on_light(key));
    if (!point) return Vec3(0);
    const Vec3 answer = answer_to(world_, s, point->direction, key);
    if (answer == Vec3(0)) return Vec3(0);
    const Vec3 sent = radiance(luminaire, point->position);
    if (sent == Vec3(0)) return Vec3(0);
    ++rays.shadow;
    const Vec3 passed =
        world_.transmittance({s.position, point->direction}, s.tolerance, point->distance);
    if (passed == Vec3(0)) return Vec3(0);
    // Light from one steradian of radiance 1 is light of colour 1/pi in POV-Ray's sense.
    return answer * sent * passed / (pi * density(*point));
}

template <class Sampler>
Vec3 DirectLight::from_picks(const Sampler& sampler, const Shading& s, const Key& key,
                             RayCounts& rays) {
    picks_.clear();
    sampler.choose(point_of(s), key, picks_);
    Vec3 sum(0);
    // The conventional way asks every luminaire once; more shadow rays are more points on each.
    const bool several = picks_.size() > 1;
    for (const LightPick& pick : picks_)
        sum +=
            from_luminaire(s, pick, several ? key.with_branch(pick.light) : key, rays,
                           [&](const LightPoint& point) { return point.density * pick.expected; });
    return sum;
}

/// Fills met_ with all luminaires on the line.
void DirectLight::meet_along(const LightTree& tree, const Shading& s, const Vec3& direction) {
    met_.clear();
    const ShadingPoint point = point_of(s);
    tree.along(s.position, direction, [&](LightIndex light) {
        meetings_.clear();
        meet(world_.luminaires[light], point, direction, meetings_);
        for (const LightMeeting& meeting : meetings_)
            // The point may lie on a luminaire, which does not light itself there.
            if (meeting.distance > s.tolerance) met_.push_back({meeting, light});
    });
    std::ranges::sort(met_, [](const Met& a, const Met& b) {
        return std::pair(a.meeting.distance, a.light) < std::pair(b.meeting.distance, b.light);
    });
}

/// The radiance of those of met_ that are seen, each times its weight.
template <class Weight>
Vec3 DirectLight::seen_along(const Shading& s, const Vec3& direction, RayCounts& rays,
                             const Weight& weight) const {
    Vec3 sum(0);
    const Ray ray{s.position, direction};
    for (const Met& met : met_) {
        ++rays.shadow;
        const Vec3 passed = world_.transmittance(ray, s.tolerance, met.meeting.distance);
        if (passed == Vec3(0)) break;
        const Luminaire& luminaire = world_.luminaires[met.light];
        sum += weight(met) * passed * radiance(luminaire, ray.at(met.meeting.distance));
        const Material& material = world_.material(luminaire.primitive);
        if (!material.transparent && !material.no_shadow) break;
    }
    return sum;
}

/// A direction from the cell's outlook, in which whatever luminaire is seen counts, or a luminaire
/// and a point on it: weighed by the density that both ways together have for a point of a
/// luminaire (one-sample multiple importance sampling). So a luminaire that the outlook does not
/// know keeps its chance, and no ray is lost where luminaires hide each other.
Vec3 DirectLight::from_cell(const Octree& octree, const Octree::Weights& weights, const Shading& s,
                            const Key& key, RayCounts& rays) {
    const ShadingPoint point = point_of(s);
    const double u = uniform(key, Purpose::light_choice), by_direction = weights.by_direction;
    if (u < by_direction) {
        const auto drawn = Outlook::draw(weights.outlook, place_on_light(key));
        const Vec3 answer = answer_to(world_, s, drawn.direction, key);
        if (answer == Vec3(0)) return Vec3(0);
        return answer / pi * seen_towards(s, drawn.direction, rays, [&](const Met& met) {
                   const double of_point =
                       octree.expected(point, weights, met.light) * met.meeting.density;
                   return 1 / (by_direction * drawn.density + (1 - by_direction) * of_point);
               });
    }
    picks_.clear();
    octree.choose(point, weights, key, (u - by_direction) / (1 - by_direction), picks_);
    if (picks_.empty()) return Vec3(0);
    const LightPick& pick = picks_.front();
    return from_luminaire(s, pick, key, rays, [&](const LightPoint& p) {
        const double of_point = pick.expected * p.density;
        if (by_direction == 0) return of_point;
        return by_direction * Outlook::density(weights.outlook, p.direction) +
               (1 - by_direction) * of_point;
    });
}

/// What a ray that is tried meets.
std::optional<LightSight> DirectLight::sight(const Ray& ray, double tolerance) const {
    Hit hit;
    if (!world_.first_hit(ray, tolerance, RayKind::light, hit)) return {};
    LightSight result{
        dot(hit.position - ray.origin, ray.direction), hit.normal, hit.tolerance, {}, 0};
    const LightIndex light = world_.luminaire_of[hit.primitive];
    if (light != no_primitive) {
        result.light = light;
        result.luminance = luminance(radiance(world_.luminaires[light], hit.position));
    }
    return result;
}

/// The radiance of all luminaires that are seen in a direction, each times its weight.
template <class Weight>
Vec3 DirectLight::seen_towards(const Shading& s, const Vec3& direction, RayCounts& rays,
                               const Weight& weight) {
    // Clear surfaces in a row that are looked through; a stop for rays that rounding keeps in one
    // place.
    constexpr int most_passed = 1000;
    ++rays.shadow;
    const ShadingPoint point = point_of(s);
    const Ray ray{s.position, direction};
    double from = s.tolerance;
    Vec3 sum(0);
    for (int passed = 0; passed < most_passed; ++passed) {
        Hit hit;
        if (!world_.first_hit(ray, from, RayKind::light, hit)) break;
        const double distance = dot(hit.position - s.position, direction);
        const LightIndex light = world_.luminaire_of[hit.primitive];
        if (light != no_primitive) {
            const Vec3 clear =
                passed == 0 ? Vec3(1) : world_.transmittance(ray, s.tolerance, distance);
            if (clear == Vec3(0)) break;
            meetings_.clear();
            meet(world_.luminaires[light], point, direction, meetings_);
            for (const LightMeeting& meeting : meetings_)
                if (std::abs(meeting.distance - distance) <= 1e-6 * distance + hit.tolerance)
                    sum += clear * weight(Met{meeting, light}) *
                           radiance(world_.luminaires[light], hit.position);
        }
        const Material& material = world_.material(hit.primitive);
        if (!material.transparent && !material.no_shadow) break;
        from = distance + hit.tolerance;
    }
    return sum;
}

Vec3 DirectLight::from_cuts(const Octree& octree, const Shading& s, const Key& key,
                            RayCounts& rays) {
    Octree::Weights weights;
    const ShadingPoint point = point_of(s);
    octree.weigh(
        point, [&](const Ray& ray, double tolerance) { return sight(ray, tolerance); }, weights);
    Vec3 sum(0);
    for (int i = 0; i < shadow_rays_; ++i)
        sum += from_cell(octree, weights, s, key.part(shadow_rays_, i), rays);
    return sum;
}

/// What other renderers do: a point on a luminaire and a direction of the surface, weighed by the
/// balance heuristic (Veach).
Vec3 DirectLight::from_pair(const BuiltLightBvh& bvh, const Shading& s, const Key& key,
                            RayCounts& rays) {
    Vec3 sum = from_surface(bvh, s, key.with_branch(1), rays);
    picks_.clear();
    bvh.choose(point_of(s), key, picks_);
    if (picks_.empty()) return sum;
    const LightPick pick = picks_.front();
    return sum + from_luminaire(s, pick, key, rays, [&](const LightPoint& point) {
               return point.density * pick.expected + scattered_density(s, point.direction);
           });
}

Vec3 DirectLight::from_surface(const BuiltLightBvh& bvh, const Shading& s, const Key& key,
                               RayCounts& rays) {
    const Vec3 direction = scattered(s, place_on_light(key));
    const Vec3 answer = answer_to(world_, s, direction, key);
    const double own = scattered_density(s, direction);
    if (answer == Vec3(0) || !(own > 0)) return Vec3(0);
    meet_along(bvh.tree(), s, direction);
    const Vec3 seen = seen_along(s, direction, rays, [&](const Met& met) {
        const double other = bvh.expected(point_of(s), key, met.light) * met.meeting.density;
        return own / (own + other);
    });
    return answer * seen / (pi * own);
}

Vec3 DirectLight::from_luminaires(const Shading& s, const Key& key, RayCounts& rays) {
    const auto repeated = [&](const auto& once) {
        Vec3 sum(0);
        for (int i = 0; i < shadow_rays_; ++i) sum += once(key.part(shadow_rays_, i));
        return sum;
    };
    const auto ask = [&](const auto& sampler) {
        using Sampler = std::decay_t<decltype(sampler)>;
        if constexpr (std::is_same_v<Sampler, BuiltLightOctree>)
            if (const Octree* octree = sampler.cuts()) return from_cuts(*octree, s, key, rays);
        if constexpr (std::is_same_v<Sampler, BuiltLightBvh>)
            if (sampler.paired())
                return repeated([&](const Key& k) { return from_pair(sampler, s, k, rays); });
        return repeated([&](const Key& k) { return from_picks(sampler, s, k, rays); });
    };
    return std::visit(ask, world_.sampler) / static_cast<double>(shadow_rays_);
}

/// A direction from where the sky is bright or the surface answers, weighed by the density that
/// both ways together have.
Vec3 DirectLight::from_sky(const Shading& s, const Key& key, RayCounts& rays) const {
    const SkyLight& sky = world_.sky_light;
    const double u = uniform(key, Purpose::sky_choice);
    const Vec2 place{uniform(key, Purpose::sky_u), uniform(key, Purpose::sky_v)};
    const Vec3 direction = u < 0.5 ? sky.draw(place).direction : scattered(s, place);
    const Vec3 answer = answer_to(world_, s, direction, key);
    if (answer == Vec3(0)) return Vec3(0);
    ++rays.shadow;
    const Vec3 passed = world_.transmittance({s.position, direction}, s.tolerance, far_away);
    if (passed == Vec3(0)) return Vec3(0);
    const double density = 0.5 * (sky.density(direction) + scattered_density(s, direction));
    return answer * passed * world_.sky_radiance(direction) / (pi * density);
}

Vec3 DirectLight::operator()(const Shading& s, const Key& key, RayCounts& rays) {
    Vec3 sum(0);
    if (!answers_light(s)) return sum;
    sum = from_sources(s, key, rays);
    if (!world_.luminaires.empty()) sum += from_luminaires(s, key, rays);
    if (world_.sky_light.empty()) return sum;
    Vec3 of_sky(0);
    for (int i = 0; i < shadow_rays_; ++i) of_sky += from_sky(s, key.part(shadow_rays_, i), rays);
    return sum + of_sky / static_cast<double>(shadow_rays_);
}
