// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/falloff.h"

#include "base/elementary.h"

#include <algorithm>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Fraction of a cone's light in a direction whose angle to the axis has this cosine, where
/// `sine_of_ball` is the sine of the ball's angular radius as seen from the point.
double in_cone(const Falloff& f, double cosine, double sine_of_ball) {
    const double ball = math::asin(sine_of_ball), dark = math::cos(f.dark);
    const double angle = std::fmax(math::acos(std::clamp(cosine, -1.0, 1.0)) - ball, 0);
    const double inside = math::cos(angle) + cone_slack - dark;
    if (!(inside > 0)) return 0;
    const double t = std::fmin(inside / std::fmax(math::cos(f.bright) - dark, cone_slack), 1);
    return std::fmax(t * t * (3 - 2 * t), cone_edge);
}

}  // namespace

double against_square_law(const Falloff& f, const Vec3& v, double radius) {
    const double away = length(v), distance = std::fmax(away, radius);
    double result = distance * distance;
    if (f.fades()) result *= 2 / (1 + math::pow(distance / f.fade_distance, f.fade_power));
    if (!f.all_around() && away > radius)
        result *= in_cone(f, -dot(f.axis, v) / away, radius / away);
    return result;
}

Falloff join(const Falloff& a, const Falloff& b) {
    Falloff result;
    if (a.fades() && b.fades()) {
        result.fade_distance = std::fmax(a.fade_distance, b.fade_distance);
        result.fade_power = std::fmin(a.fade_power, b.fade_power);
    }
    if (a.all_around() || b.all_around()) return result;
    const Vec3 sum = a.axis + b.axis;
    if (!(dot(sum, sum) > 1e-6)) return result;
    const Vec3 axis = unit(sum);
    const auto around = [&](const Vec3& other) {
        return math::acos(std::clamp(dot(axis, other), -1.0, 1.0)) * (1 + 1e-9) + 1e-7;
    };
    const double turn_a = around(a.axis), turn_b = around(b.axis);
    result.dark = std::fmax(turn_a + a.dark, turn_b + b.dark);
    if (result.dark >= pi) {
        result.dark = pi;
        return result;
    }
    result.axis = axis;
    result.bright = std::fmin(std::fmax(turn_a + a.bright, turn_b + b.bright), result.dark);
    return result;
}

}  // namespace candelabra
