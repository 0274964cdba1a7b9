// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/bent_normals.h"

#include "base/circle.h"
#include "base/parallel.h"
#include "base/random.h"
#include "world/radiance.h"

#include <numbers>

namespace candelabra {

namespace {

/// Number of rays of all luminaires together that any picture may take, number of them for a pixel
/// of a large one, whose samples take far longer, and maximum number of pairs of opposite rays of a
/// luminaire: see "Bent normals" in tests/bench/README.md.
constexpr std::uint64_t usual_rays = std::uint64_t{1} << 18, rays_of_pixel = 2;
constexpr std::uint64_t max_pairs = 4;
/// Distance from the centre, in radii, of the points to which rays lead.
constexpr double around = 3;
/// Fraction of a flat luminaire's radius within which a surface is its mounting.
constexpr double mounted = 0.5;
/// Offsets of the ends of rays, as fractions of the luminaire's radius and of the distance from the
/// origin.
constexpr double apart = 1e-4, rounding = 1e-9;
/// Number of luminaires that one job handles.
constexpr std::size_t chunk = 256;
/// Number of extra rays that count as unoccluded, because few rays are traced: for each side of a
/// flat luminaire, and for a round one.
constexpr double flat_doubt = 0.25, round_doubt = 1;
/// Maximum length of a bent normal.
constexpr double max_length = 0.48;

double number(std::size_t light, std::size_t ray, std::uint32_t which) {
    return uniform(Key::of(Survey::bent_normals, light, static_cast<std::uint32_t>(ray), which),
                   Purpose::survey);
}

/// Whether light that leaves the point gets that far, and does not start inside of a solid.
bool gets_away(const World& world, const std::optional<Vec3>& eye, const Ray& ray, double start,
               double far) {
    double behind = start;
    bool away = true;
    world.along(ray, start, RayKind::light, [&](const Hit& hit, double distance) {
        if (!world.material(hit.primitive).stops_light()) {
            behind = distance + hit.tolerance;
            return true;
        }
        const auto within = [&](const Vec3& point) {
            return world.contains_point(hit.primitive, point);
        };
        away = distance >= far &&
               ((eye && within(*eye)) || !within(ray.at(0.5 * (behind + distance))));
        return false;
    });
    return away;
}

/// Number of traced rays of a luminaire, and sums over the unoccluded ones.
struct Tried {
    double to_axis = 0, from_axis = 0, away_to_axis = 0, away_from_axis = 0;
    Vec3 directions = Vec3(0);

    double all() const { return to_axis + from_axis; }
    double away() const { return away_to_axis + away_from_axis; }
};

Vec3 bent_normal_of_flat(const Tried& tried, const Vec3& axis) {
    const double front = (tried.away_to_axis + flat_doubt) / (tried.to_axis + flat_doubt),
                 back = (tried.away_from_axis + flat_doubt) / (tried.from_axis + flat_doubt);
    const double length = 0.5 * (front - back) / std::fmax(front, back);
    return std::clamp(length, -max_length, max_length) * axis;
}

/// The bent normal as if a fraction open + dot(bent, direction) of the light were unoccluded.
Vec3 bent_normal_of_round(const Tried& tried) {
    const double all = tried.all() + round_doubt;
    const double open = (tried.away() + round_doubt) / all;
    const Vec3 bent = 3 / all * tried.directions;
    const double size = length(bent);
    if (!(size > 0)) return Vec3(0);
    return std::fmin(1 / (open + size), max_length / size) * bent;
}

/// Whether a luminaire emits nothing towards a place where a point of it was drawn.
bool is_dark(const World& world, const Luminaire& luminaire, const Vec3& from,
             const LightPoint& point) {
    return luminaire.one_sided &&
           radiance_seen(world, luminaire, {{from, point.direction}, 0, point.distance}) == Rgb(0);
}
bool is_dark(const World&, const MediaBox&, const Vec3&, const LightPoint&) { return false; }

/// Of a luminaire or a box of media; `light` is its number.
template <class Glowing>
Vec3 bent_normal_of(const World& world, const Glowing& glowing, std::size_t light,
                    const std::optional<Vec3>& eye, std::size_t pairs) {
    const LightBounds b = bounds(glowing);
    const bool flat = b.axis != Vec3(0);
    const Vec3 pole = flat ? b.axis : Vec3(0, 0, 1);
    const Vec3 side = unit(cross(pole, std::abs(pole.x) < 0.7 ? Vec3(1, 0, 0) : Vec3(0, 1, 0))),
               other = cross(pole, side);
    const double start = apart * b.radius + rounding * max_abs_component(b.centre),
                 near = flat ? mounted * b.radius : 0;
    Tried tried;
    for (std::size_t i = 0; i < 2 * pairs; ++i) {
        const std::size_t pair = i / 2;
        const double height =
            (static_cast<double>(pair) + number(light, pair, 0)) / static_cast<double>(pairs);
        const double angle = 2 * std::numbers::pi * number(light, pair, 1),
                     across = std::sqrt(1 - height * height);
        const Vec3 up = height * pole + across * on_circle(angle, side, other);
        const Vec3 direction = i % 2 == 0 ? up : -up;
        const Vec3 from = b.centre + around * b.radius * direction;
        const auto point = sample(glowing, from, {number(light, i, 2), number(light, i, 3)});
        if (!point) continue;
        const bool away = !is_dark(world, glowing, from, *point) &&
                          gets_away(world, eye, {point->position, -point->direction}, start, near);
        const bool to_axis = i % 2 == 0;
        (to_axis ? tried.to_axis : tried.from_axis) += 1;
        if (!away) continue;
        (to_axis ? tried.away_to_axis : tried.away_from_axis) += 1;
        tried.directions += direction;
    }
    if (tried.away() == 0) return Vec3(0);
    return flat ? bent_normal_of_flat(tried, b.axis) : bent_normal_of_round(tried);
}

}  // namespace

std::vector<Vec3> find_bent_normals(const World& world, const std::optional<Vec3>& eye,
                                    std::uint64_t pixels, int threads) {
    const std::size_t count = world.lights.glowing();
    if (count < 2 || !world.lights.luminaires.placed().empty()) return {};
    const std::uint64_t rays = std::max(usual_rays, rays_of_pixel * pixels),
                        pairs = std::min(max_pairs, rays / (2 * count));
    if (pairs == 0) return {};
    std::vector<Vec3> found(count);
    run_parallel((count + chunk - 1) / chunk, threads, [&](std::size_t n) {
        for (std::size_t light = n * chunk; light < std::min((n + 1) * chunk, count); ++light)
            found[light] =
                world.lights.visit(static_cast<LightIndex>(light), [&](const auto& glowing) {
                    return bent_normal_of(world, glowing, light, eye, pairs);
                });
    });
    return found;
}

}  // namespace candelabra
