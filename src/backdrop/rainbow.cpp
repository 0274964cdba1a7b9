// SPDX-License-Identifier: GPL-3.0-or-later
#include "backdrop/rainbow.h"

#include "base/degrees.h"
#include "base/elementary.h"
#include "vocabulary/schema.h"

#include <algorithm>

namespace candelabra {

const ItemInfo Rainbow::vocabulary = described<Rainbow>([] {
    using F = Field<Rainbow>;
    return schema<Rainbow>(
        "rainbow",
        {"Coloured arcs around a direction; color_map { } has the colours.",
         "rainbow { direction <0.2, -0.3, 1> angle 42.5 width 5 distance 1000 jitter 0.01 up y "
         "arc_angle 120 falloff_angle 30 color_map { [0 rgbt <1, 0, 0, 1>] [0.5 rgbt <0, 1, 0, "
         "0.7>] [1 rgbt <0, 0, 1, 1>] } }"},
        F{"direction", &Rainbow::direction, item, "in which the light goes: the middle of the arc"},
        F{"angle", &Rainbow::angle, item, "degrees from there to the middle of the band"},
        F{"width", &Rainbow::width, item,
          "of the band, in degrees; below 0: its colours are reversed"},
        F{"distance", &Rainbow::distance, item, "where 37 % of what is behind are left"},
        F{"jitter", &Rainbow::jitter, item, "how far colours are mixed at random"},
        F{"up", &Rainbow::up, item, "where the middle of the arc is"},
        F{"arc_angle", &Rainbow::arc_angle, item, "degrees of the circle that are there",
          between(0, 360)},
        F{"falloff_angle", &Rainbow::falloff_angle, item,
          "degrees of the circle that do not fade; default: all", between(0, 360)});
});

namespace {

double angle_between(const Vec3& a, const Vec3& b) {
    return math::acos(std::clamp(dot(a, b), -1.0, 1.0)) / radians_per_degree;
}

/// How far the arc has faded towards its ends: 0 to 1; above 1 beyond the arc.
double faded(const Rainbow& rainbow, const Vec3& ahead, const Vec3& direction) {
    if (rainbow.arc_angle >= 360) return 0;
    const auto across = [&](const Vec3& v) { return unit(v - dot(v, ahead) * ahead); };
    const double from_top = angle_between(across(rainbow.up), across(direction));
    const double end = 0.5 * rainbow.arc_angle;
    const double begin = 0.5 * rainbow.falloff_angle.value_or(rainbow.arc_angle);
    if (from_top > end) return 2;
    if (from_top <= begin) return 0;
    const double x = (from_top - begin) / (end - begin);
    return x * x * (3 - 2 * x);
}

/// Returns nothing outside the rainbow.
std::optional<Veil> veil_of(const Rainbow& rainbow, const Ray& ray, double distance,
                            double chance) {
    if (rainbow.width == 0 || rainbow.distance == 0) return std::nullopt;
    const Vec3 ahead = unit(rainbow.direction);
    if (dot(ray.direction, ahead) < 0) return std::nullopt;
    const double from_middle = angle_between(ray.direction, ahead) - rainbow.angle;
    const double place = from_middle / rainbow.width + 0.5 + rainbow.jitter * (2 * chance - 1);
    if (!(place >= 0 && place < 1)) return std::nullopt;
    const double fade = faded(rainbow, ahead, ray.direction);
    if (fade > 1) return std::nullopt;
    const Colour colour = look_up(rainbow.map, place);
    const double kept = std::max(math::exp(-distance / rainbow.distance),
                                 fade * (1 - colour.transmit) + colour.transmit);
    const double own = 1 - kept, tint = colour.filter * own;
    return Veil{kept * (Rgb(1 - tint) + tint * colour.rgb), own * colour.rgb};
}

}  // namespace

std::string problem(const Rainbow& rainbow) {
    if (rainbow.direction == Vec3(0)) return "`rainbow` needs a `direction`";
    return rainbow.up == Vec3(0) ? "`up` of `rainbow` must not be zero" : "";
}

Veil veil_of(std::span<const Rainbow> rainbows, const Ray& ray, double distance, double chance) {
    Veil sum{Rgb(0), Rgb(0)};
    double count = 0;
    for (const Rainbow& rainbow : rainbows) {
        const auto one = veil_of(rainbow, ray, distance, chance);
        if (!one) continue;
        sum.transmittance += one->transmittance;
        sum.added += one->added;
        ++count;
    }
    return count == 0 ? Veil() : Veil{sum.transmittance / count, sum.added / count};
}

}  // namespace candelabra
