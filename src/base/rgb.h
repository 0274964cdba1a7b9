// SPDX-License-Identifier: GPL-3.0-or-later
// Light and its factors, one number for each colour channel. Points and directions are Vec3: the
// two types do not mix, so that the compiler finds a direction in the place of a radiance.
#pragma once

#include "base/elementary.h"
#include "base/vector.h"

#include <cmath>

namespace candelabra {

/// An amount of light (radiance, irradiance, power), or what changes it (reflectance,
/// transmittance, throughput, a coefficient of a medium), in linear red, green and blue. Products
/// and quotients are by channel.
struct Rgb {
    double r = 0, g = 0, b = 0;

    constexpr Rgb() = default;
    /// The same in all channels.
    constexpr explicit Rgb(double grey) : r(grey), g(grey), b(grey) {}
    constexpr Rgb(double red, double green, double blue) : r(red), g(green), b(blue) {}

    /// Channel 0 to 2.
    constexpr double& operator[](int channel) { return channel == 0 ? r : channel == 1 ? g : b; }
    constexpr const double& operator[](int channel) const {
        return channel == 0 ? r : channel == 1 ? g : b;
    }

    constexpr Rgb operator-() const { return {-r, -g, -b}; }
    constexpr Rgb& operator+=(const Rgb& o) { return *this = {r + o.r, g + o.g, b + o.b}; }
    constexpr Rgb& operator-=(const Rgb& o) { return *this = {r - o.r, g - o.g, b - o.b}; }
    constexpr Rgb& operator*=(const Rgb& o) { return *this = {r * o.r, g * o.g, b * o.b}; }
    constexpr Rgb& operator/=(const Rgb& o) { return *this = {r / o.r, g / o.g, b / o.b}; }
    constexpr Rgb& operator*=(double factor) { return *this *= Rgb(factor); }
    constexpr Rgb& operator/=(double divisor) { return *this /= Rgb(divisor); }

    friend constexpr Rgb operator+(Rgb x, const Rgb& y) { return x += y; }
    friend constexpr Rgb operator-(Rgb x, const Rgb& y) { return x -= y; }
    friend constexpr Rgb operator*(Rgb x, const Rgb& y) { return x *= y; }
    friend constexpr Rgb operator/(Rgb x, const Rgb& y) { return x /= y; }
    friend constexpr Rgb operator*(Rgb x, double factor) { return x *= factor; }
    friend constexpr Rgb operator*(double factor, Rgb x) { return x *= factor; }
    friend constexpr Rgb operator/(Rgb x, double divisor) { return x /= divisor; }
    friend constexpr bool operator==(const Rgb&, const Rgb&) = default;
};

/// Where numbers of either kind are meant: values of the scene language, files, displays.
constexpr Rgb rgb_of(const Vec3& v) { return {v.x, v.y, v.z}; }
constexpr Vec3 vec3_of(const Rgb& c) { return {c.r, c.g, c.b}; }

// By channel.
inline Rgb abs(const Rgb& c) { return {std::abs(c.r), std::abs(c.g), std::abs(c.b)}; }
/// A channel that is NaN in x stays NaN.
constexpr Rgb max(const Rgb& x, const Rgb& y) {
    return {x.r < y.r ? y.r : x.r, x.g < y.g ? y.g : x.g, x.b < y.b ? y.b : x.b};
}
constexpr Rgb min(const Rgb& x, const Rgb& y) {
    return {y.r < x.r ? y.r : x.r, y.g < x.g ? y.g : x.g, y.b < x.b ? y.b : x.b};
}
constexpr Rgb clamp(const Rgb& c, const Rgb& low, const Rgb& high) {
    return min(max(c, low), high);
}
/// From x to y as share goes from 0 to 1.
constexpr Rgb mix(const Rgb& x, const Rgb& y, double share) { return x * (1 - share) + y * share; }
inline Rgb sqrt(const Rgb& c) { return {std::sqrt(c.r), std::sqrt(c.g), std::sqrt(c.b)}; }
namespace math {
inline Rgb exp(const Rgb& c) { return {exp(c.r), exp(c.g), exp(c.b)}; }
}  // namespace math

inline double max_component(const Rgb& c) { return std::fmax(c.r, std::fmax(c.g, c.b)); }
inline double min_component(const Rgb& c) { return std::fmin(c.r, std::fmin(c.g, c.b)); }
inline double max_abs_component(const Rgb& c) { return max_component(abs(c)); }

}  // namespace candelabra
