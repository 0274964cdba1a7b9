// SPDX-License-Identifier: GPL-3.0-or-later
// The transfer curves of ITU-R for video, which pictures that are read or written may have.
#pragma once

#include "base/elementary.h"
#include "base/gamma.h"

#include <optional>
#include <string_view>

namespace candelabra {

/// The gammas that stand for these curves, beside srgb_gamma.
inline constexpr double bt709_gamma = -2, bt2020_gamma = -3;

/// The power that is nearest to both curves, for files that can only state a power.
inline constexpr double video_power = 1.96;

/// The gamma of a curve by its name in scenes.
inline std::optional<double> gamma_called(std::string_view name) {
    if (name == "srgb") return srgb_gamma;
    if (name == "bt709") return bt709_gamma;
    if (name == "bt2020") return bt2020_gamma;
    return std::nullopt;
}

/// The linear light of a value by BT.709-6, 1.2, or by BT.2020-2, table 4 (for 12 bits).
inline double video_decode(double value, double gamma) {
    constexpr double slope = 4.5, exponent = 0.45;
    const double scale = gamma == bt709_gamma ? 1.099 : 1.0993;
    const double knee = gamma == bt709_gamma ? 0.018 : 0.0181;
    if (value < slope * knee) return value / slope;
    return math::pow((value + (scale - 1)) / scale, 1 / exponent);
}

/// The inverse of video_decode().
inline double video_encode(double light, double gamma) {
    constexpr double slope = 4.5, exponent = 0.45;
    const double scale = gamma == bt709_gamma ? 1.099 : 1.0993;
    const double knee = gamma == bt709_gamma ? 0.018 : 0.0181;
    return light < knee ? slope * light : scale * math::pow(light, exponent) - (scale - 1);
}

/// The inverse of light_of().
inline double value_of(double light, double gamma) {
    if (gamma == bt709_gamma || gamma == bt2020_gamma) return video_encode(light, gamma);
    return from_linear(light, gamma);
}

/// The linear light of a value by any curve or power that a scene states.
inline double light_of(double value, double gamma) {
    if (gamma == bt709_gamma || gamma == bt2020_gamma) return video_decode(value, gamma);
    return to_linear(value, gamma);
}

}  // namespace candelabra
