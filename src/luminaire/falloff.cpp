// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/falloff.h"

#include "base/elementary.h"

#include <algorithm>

namespace candelabra {

FalloffTerms<double> terms_of(const Falloff& f, double scale) {
    FalloffTerms<double> result;
    if (f.fades()) {
        result.fade_power = f.fade_power;
        result.per_fade_distance = 1 / std::fmax(f.fade_distance * scale, 1e-30);
    }
    result.axis = f.axis;
    if (f.all_around()) return result;
    result.dark = math::cos(f.dark);
    result.per_edge = 1 / std::fmax(math::cos(f.bright) - result.dark, cone_slack);
    return result;
}

double against_square_law(const Falloff& f, const Vec3& v, double radius) {
    const auto power = [](double x, double p) { return p > 0 ? math::pow(x, p) : 1; };
    return against_square_law(terms_of(f), v, radius, power);
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
    if (result.dark >= std::numbers::pi) {
        result.dark = std::numbers::pi;
        return result;
    }
    result.axis = axis;
    result.bright = std::fmin(std::fmax(turn_a + a.bright, turn_b + b.bright), result.dark);
    return result;
}

}  // namespace candelabra
