// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/source_rays.h"

#include "base/degrees.h"
#include "base/elementary.h"
#include "base/random.h"
#include "lighting/draw.h"
#include "luminaire/luminaire.h"
#include "transport/aim.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Fraction of the rays of a source outside of a region that go in all of its directions.
constexpr double unaimed = 1.0 / 32;
/// Number of rays of all sources together that estimate their light, and maximum number of each.
constexpr std::size_t estimating_rays = 1 << 16, rays_of_each = 64;
/// Number of trials that find which starts of all sources matter, maximum number in each cell of a
/// guide, and maximum number of sources for which they are found.
constexpr std::size_t all_trials = 1 << 13, trials_of_cell = 16, learned_sources = 16;
/// Fraction of the choices among sources that ignores these trials.
constexpr double by_power = 0.25;
constexpr std::uint64_t trial_stream = 0x57a7;
/// Minimum probability of a source, as a fraction of what it had with the greatest light of its
/// shape in all of its directions.
constexpr double least_share = 0.05;

bool meets_ball(const Ray& ray, const TargetBall& ball) {
    const Vec3 offset = ball.centre - ray.origin;
    const double along = dot(offset, ray.direction), away2 = dot(offset, offset),
                 radius2 = ball.radius * ball.radius;
    return away2 <= radius2 || (along > 0 && away2 - along * along <= radius2 * (1 + 1e-9));
}

/// Returns the cone of directions from a point to a ball; all directions if the point is inside.
LightCone cone_to(const Vec3& from, const TargetBall& ball) {
    const Vec3 offset = ball.centre - from;
    const double away2 = dot(offset, offset), radius2 = ball.radius * ball.radius;
    if (away2 <= radius2) return all_directions;
    return {offset / std::sqrt(away2), std::sqrt(1 - radius2 / away2)};
}

/// The directions in which a source may send light that is not parallel; all of them if it has a
/// web, whose cone would have to be found for each ray.
LightCone own_cone(const PointLight& light) {
    return light.web ? all_directions : cone_around(light);
}

/// Radius of the light of a cylinder; nothing if the source has none.
std::optional<double> beam_of(const PointLight& light) {
    if (light.kept_to() != parallel_beam) return std::nullopt;
    return std::fmax(light.falloff.value_or(1), 0);
}

/// Samples a ray in the narrower one of two cones: that to the ball, and the light's own.
std::optional<SourceRay> from_point(const TargetBall& ball, const PointLight& light,
                                    const Vec3& place, const Vec2& u) {
    LightCone drawn = cone_to(place, ball);
    const LightCone shape = own_cone(light);
    const bool own = shape.cosine > drawn.cosine;
    if (own) drawn = shape;
    const SourceRay sent{&light, place, {place, direction_in_cone(drawn, u)}, drawn.steradians()};
    if (own && !meets_ball(sent.ray, ball)) return std::nullopt;
    return sent;
}

/// Samples a ray of parallel light, which starts in the plane through the light.
std::optional<SourceRay> from_plane(const TargetBall& ball, const PointLight& light,
                                    const Vec3& place, const Vec2& u) {
    const Vec3 along = unit(light.point_at - place);
    const std::optional<double> beam = beam_of(light);
    const bool own = beam && *beam < ball.radius;
    const double radius = own ? *beam : ball.radius;
    const Vec3 point = (own ? light.location : ball.centre) + point_in_disc(along, radius, u);
    const SourceRay sent{
        &light, place, {point - dot(point - place, along) * along, along}, pi * radius * radius};
    if (own && !meets_ball(sent.ray, ball)) return std::nullopt;
    return sent;
}

/// Samples a direction of a source that is not parallel. From outside of the region, a direction to
/// a point about the disc that the source sees of it is drawn mostly.
SourceRay point_anywhere(const LitRegion& region, const PointLight& light, const Vec2& u) {
    const Vec3& from = light.location;
    const LightCone own = own_cone(light);
    const double away = length(region.centre - from), radius = region.radius;
    const bool narrow = own.steradians() < pi * radius * radius / (away * away);
    const Aim aim(region, from, narrow ? 0 : 1 - unaimed);
    const Vec3 direction = aim.draw(u, [&](const Vec2& v) { return direction_in_cone(own, v); });
    const bool inside = dot(direction, own.axis) >= own.cosine;
    return {&light,
            from,
            {from, direction},
            1 / aim.density(direction, narrow || inside ? 1 / own.steradians() : 0)};
}

SourceRay plane_anywhere(const LitRegion& region, const PointLight& light, const Vec2& u) {
    const Vec3 along = axis_of(light);
    const std::optional<double> beam = beam_of(light);
    if (beam && *beam < region.radius)
        return {&light,
                light.location,
                {light.location + point_in_disc(along, *beam, u), along},
                pi * *beam * *beam};
    const Vec3 aside = point_about_disc(along, region.radius, u);
    const Vec3 point = region.centre + aside;
    const double behind = dot(point - light.location, along);
    // No light of a cylinder is behind its plane.
    const double start = beam ? behind : std::fmax(behind, region.upstream);
    return {&light,
            light.location,
            {point - start * along, along},
            area_about_disc(length(aside), region.radius)};
}

/// About the light that a source sends into the region, as luminance.
double power_into(const LitRegion& region, const PointLight& light, std::size_t rays) {
    if (is_aimless(light) || light.colour == Rgb(0)) return 0;
    const double usual = std::fmax(length(region.centre - light.location), region.radius);
    PointLight plain = light;
    plain.beam = all_around;
    plain.web = nullptr;
    plain.parallel = light.along_axis();
    double shaped = 0, whole = 0;
    for (std::size_t i = 0; i < rays; ++i) {
        const Key key{0, static_cast<std::uint32_t>(i), 0, 0};
        const SourceRay sent = ray_anywhere(region, light, place_on_light(key));
        // Of a parallel ray, where it is nearest to the region.
        const double way =
            light.along_axis() ? dot(region.centre - sent.ray.origin, sent.ray.direction) : usual;
        const double area = sent.area_after(way);
        if (light.along_axis() && area > 4 * pi * region.radius * region.radius) continue;
        const auto lit = [&](const PointLight& as) {
            return luminance(abs(incidence(as, light.location, sent.ray.at(way)).colour));
        };
        shaped += lit(light) * area;
        whole += lit(plain) * area;
    }
    const double power = std::fmax(shaped, least_share * whole) / static_cast<double>(rays);
    return std::isfinite(power) ? power : 0;
}

}  // namespace

Vec3 direction_in_cone(const LightCone& cone, const Vec2& u) {
    return unit(turned_from(cone.axis, 1 - u.x * (1 - cone.cosine), 2 * pi * u.y));
}

std::optional<SourceRay> ray_into(const TargetBall& ball, const PointLight& light,
                                  const Vec3& place, const Vec2& u) {
    return light.along_axis() ? from_plane(ball, light, place, u)
                              : from_point(ball, light, place, u);
}

Vec2 place_in_grid(const Key& key) {
    return {uniform(key, Purpose::sent_grid_u), uniform(key, Purpose::sent_grid_v)};
}

SourceRay ray_anywhere(const LitRegion& region, const PointLight& light, const Vec2& u) {
    return light.along_axis() ? plane_anywhere(region, light, u) : point_anywhere(region, light, u);
}

SourceRays::SourceRays(std::span<const PointLight> sources, const LitRegion& region)
    : sources_(sources), region_(region) {
    const std::size_t rays =
        std::clamp<std::size_t>(estimating_rays / (sources.size() + 1), 1, rays_of_each);
    powers_.reserve(sources.size());
    for (const PointLight& light : sources) {
        powers_.push_back(power_into(region, light, rays));
        power_ += powers_.back();
    }
    places_ = WeightedIndex(powers_);
}

SourceRays::Drawn SourceRays::draw(double choice, const Vec2& u) const {
    const std::uint32_t number = places_.at_share(choice);
    const StartGuide::Drawn start =
        guides_.empty() ? StartGuide::Drawn{u, 1} : guides_[number].draw(u);
    Drawn drawn{number, ray_anywhere(region_, sources_[number], start.place)};
    drawn.ray.extent *= start.factor / places_.share_of(number);
    return drawn;
}

void SourceRays::learn(FunctionRef<double(const Drawn&, const Key&)> worth) {
    const auto lit = static_cast<std::size_t>(
        std::ranges::count_if(powers_, [](double power) { return power > 0; }));
    if (lit == 0 || lit > learned_sources) return;
    const std::size_t trials =
        std::clamp<std::size_t>(all_trials / lit / StartTrials::cells, 1, trials_of_cell) *
        StartTrials::cells;
    guides_.resize(sources_.size());
    std::vector<double> worths(sources_.size(), 0.0);
    double all = 0;
    for (std::uint32_t number = 0; number < sources_.size(); ++number) {
        if (!(powers_[number] > 0)) continue;
        StartTrials tried;
        for (std::size_t i = 0; i < trials; ++i) {
            const Key key{trial_stream, static_cast<std::uint32_t>(i), number, 0};
            const Vec2 place = StartTrials::place(i, place_on_light(key));
            tried.add(i, worth({number, ray_anywhere(region_, sources_[number], place)}, key));
        }
        guides_[number] = StartGuide(tried);
        worths[number] = tried.sum();
        all += tried.sum();
    }
    if (!(all > 0) || !std::isfinite(all)) return;
    for (std::size_t i = 0; i < worths.size(); ++i)
        worths[i] = (1 - by_power) * worths[i] / all + by_power * powers_[i] / power_;
    places_ = WeightedIndex(worths);
}

}  // namespace candelabra
