// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/response.h"

#include "base/elementary.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

constexpr double middle_grey = 0.18;

/// Hable's curve for x >= 0.
double hable(double x) {
    constexpr double shoulder = 0.15, linear = 0.5, angle = 0.1, toe = 0.2, toe_top = 0.02,
                     toe_bottom = 0.3;
    return (x * (shoulder * x + angle * linear) + toe * toe_top) /
               (x * (shoulder * x + linear) + toe * toe_bottom) -
           toe_top / toe_bottom;
}

/// Exposure of white, in Hable's units.
constexpr double hable_white = 11.2;
/// Factor on the exposure that preserves the grey: the solution of hable(k * 0.18) = 0.18
/// hable(11.2).
constexpr double hable_gain = 2.9275228328801886;

constexpr double stops_below = 10, stops_above = 6.5;
constexpr double pivot_place = stops_below / (stops_below + stops_above);
/// Exponent from values of the curve to linear light.
constexpr double curve_gamma = 2.2;
constexpr double slope = 2, toe_power = 3, shoulder_power = 3.25;

/// Returns a line through 0 with the given slope, which bends to reach `room` at x = `way`.
double bent(double x, double way, double room, double power) {
    const double scale =
        room == 0
            ? 0
            : math::pow(math::pow(slope * way, -power) * (math::pow(slope * way / room, power) - 1),
                        -1 / power);
    const double steep = slope * x / scale;
    return scale * steep / math::pow(1 + math::pow(steep, power), 1 / power);
}

Rgb mixed(const Rgb& c, double share) {
    return (1 - share) * c + Rgb(share * (c.r + c.g + c.b) / 3);
}

/// Light whose channels are finite, so that they can be compared by division.
constexpr double agx_most = 1e30;

Rgb agx(const Rgb& exposure) {
    const auto [mixed_in, taken_back, kept_in_proportion, half_kept_exposure] = agx_mixing;
    const Rgb light = clamp(exposure, Rgb(0), Rgb(agx_most));
    Rgb made = mixed(light, mixed_in);
    for (int i = 0; i < 3; ++i) made[i] = agx_curve(made[i]);
    const double grey = (made.r + made.g + made.b) / 3;
    made = (made - Rgb(taken_back * grey)) / (1 - taken_back);
    const double brightest = max_component(light);
    if (brightest == 0) return made;
    const Rgb in_proportion = agx_curve(brightest) / brightest * light;
    const double share = kept_in_proportion / (1 + brightest / half_kept_exposure);
    return made + share * (in_proportion - made);
}

}  // namespace

double filmic_curve(double exposure) {
    if (!(exposure > 0)) return 0;
    // Far above white, where the curve is flat.
    constexpr double enough = 1e6;
    return std::min(hable(hable_gain * std::min(exposure, enough)) / hable(hable_white), 1.0);
}

double agx_curve(double exposure) {
    if (!(exposure > 0)) return 0;
    const double stops = math::log2(exposure / middle_grey);
    const double place = std::clamp((stops + stops_below) / (stops_below + stops_above), 0.0, 1.0);
    static const double pivot = math::pow(middle_grey, 1 / curve_gamma);
    const double shown =
        place < pivot_place
            ? pivot - bent(pivot_place - place, pivot_place, pivot, toe_power)
            : pivot + bent(place - pivot_place, 1 - pivot_place, 1 - pivot, shoulder_power);
    return math::pow(std::clamp(shown, 0.0, 1.0), curve_gamma);
}

Rgb respond(ResponseCurve curve, const Rgb& exposure) {
    Rgb known = exposure;
    for (int i = 0; i < 3; ++i)
        if (std::isnan(known[i])) known[i] = 0;
    if (curve == ResponseCurve::filmic)
        known = {filmic_curve(known.r), filmic_curve(known.g), filmic_curve(known.b)};
    if (curve == ResponseCurve::agx) known = agx(known);
    return clamp(known, Rgb(0), Rgb(1));
}

}  // namespace candelabra
