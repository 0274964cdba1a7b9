// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/photometric_web.h"

#include "base/between.h"
#include "base/degrees.h"
#include "base/elementary.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace candelabra {

namespace {

constexpr double whole_turn = 360;

/// Returns the place of an angle; nothing outside the list, beyond what rounding explains.
std::optional<Between> place_in(const std::vector<double>& angles, double angle) {
    constexpr double rounding = 1e-9;
    if (!(angle >= angles.front() - rounding && angle <= angles.back() + rounding))
        return std::nullopt;
    return place_between(angles, angle);
}

/// Integral of a linear function from `low` at a to `high` at b, times the sine of the angle.
double times_sine(double a, double b, double low, double high) {
    const double slope = (high - low) / (b - a);
    return low * math::cos(a) - high * math::cos(b) + slope * (math::sin(b) - math::sin(a));
}

/// The same times the cosine of the angle.
double times_cosine(double a, double b, double low, double high) {
    const double slope = (high - low) / (b - a);
    return high * math::sin(b) - low * math::sin(a) + slope * (math::cos(b) - math::cos(a));
}

}  // namespace

PhotometricWeb::PhotometricWeb(WebType type, std::vector<double> vertical,
                               std::vector<double> horizontal, std::vector<double> candela)
    : type_(type),
      vertical_(std::move(vertical)),
      horizontal_(std::move(horizontal)),
      candela_(std::move(candela)) {}

double PhotometricWeb::intensity(const Vec3& direction) const {
    return intensity(angles_of(type_, direction));
}

double PhotometricWeb::intensity(const WebAngles& angles) const {
    if (candela_.empty()) return 0;
    double around = angles.horizontal;
    if (type_ == WebType::c) {
        const double first = horizontal_.front();
        around = first + std::fmod(around - first, whole_turn);
        if (around < first) around += whole_turn;
    }
    const auto row = place_in(vertical_, angles.vertical);
    const auto plane = place_in(horizontal_, around);
    if (!row || !plane) return 0;
    const auto in_plane = [&](std::size_t p) {
        const double low = at(p, row->low), high = at(p, row->high);
        return low + row->fraction * (high - low);
    };
    const double before = in_plane(plane->low), after = in_plane(plane->high);
    return before + plane->fraction * (after - before);
}

/// The integral is exact along the angle that the solid angle depends on, the latitude, and linear
/// along the other, so the trapezium rule is exact there. `from` and `to` bound V of type C.
double PhotometricWeb::flux_between(double from, double to) const {
    if (candela_.empty()) return 0;
    const bool latitude_is_vertical = type_ != WebType::b;
    const std::vector<double>& latitudes = latitude_is_vertical ? vertical_ : horizontal_;
    const std::vector<double>& longitudes = latitude_is_vertical ? horizontal_ : vertical_;
    const auto value = [&](std::size_t longitude, std::size_t latitude) {
        return latitude_is_vertical ? at(longitude, latitude) : at(latitude, longitude);
    };
    const auto along = [&](std::size_t longitude) {
        double sum = 0;
        for (std::size_t i = 0; i + 1 < latitudes.size(); ++i) {
            const double start = latitudes[i], end = latitudes[i + 1];
            const double low = std::max(start, from), high = std::min(end, to);
            if (low >= high) continue;
            const auto at_angle = [&](double angle) {
                const double before = value(longitude, i), after = value(longitude, i + 1);
                return before + (angle - start) / (end - start) * (after - before);
            };
            const double a = low * radians_per_degree, b = high * radians_per_degree;
            sum += type_ == WebType::c ? times_sine(a, b, at_angle(low), at_angle(high))
                                       : times_cosine(a, b, at_angle(low), at_angle(high));
        }
        return sum;
    };
    double sum = 0, before = along(0);
    for (std::size_t i = 0; i + 1 < longitudes.size(); ++i) {
        const double after = along(i + 1);
        sum += (longitudes[i + 1] - longitudes[i]) * radians_per_degree * (before + after) / 2;
        before = after;
    }
    return sum;
}

double PhotometricWeb::flux() const { return flux_between(-whole_turn, whole_turn); }

double PhotometricWeb::flux_down() const {
    constexpr double horizon = 90;
    return flux_between(0, horizon);
}

WebAngles PhotometricWeb::peak() const {
    if (candela_.empty()) return {};
    const auto most = std::ranges::max_element(candela_);
    const auto place = static_cast<std::size_t>(most - candela_.begin());
    return {vertical_[place % vertical_.size()], horizontal_[place / vertical_.size()]};
}

WebAngles angles_of(WebType type, const Vec3& direction) {
    const Vec3 d = unit(direction);
    const auto degrees = [](double radians) { return radians / radians_per_degree; };
    const auto arc = [&](double sine) { return degrees(math::asin(std::clamp(sine, -1.0, 1.0))); };
    if (type == WebType::a) return {arc(d.z), degrees(math::atan2(-d.y, d.x))};
    if (type == WebType::b) return {degrees(math::atan2(d.x, -d.z)), arc(-d.y)};
    const double around = degrees(math::atan2(d.y, d.x));
    return {degrees(math::acos(std::clamp(-d.z, -1.0, 1.0))),
            around < 0 ? around + whole_turn : around};
}

Vec3 direction_of(WebType type, const WebAngles& angles) {
    const auto [sin_v, cos_v] = math::sin_cos(angles.vertical * radians_per_degree);
    const auto [sin_h, cos_h] = math::sin_cos(angles.horizontal * radians_per_degree);
    if (type == WebType::a) return {cos_v * cos_h, -cos_v * sin_h, sin_v};
    if (type == WebType::b) return {cos_h * sin_v, -sin_h, -cos_h * cos_v};
    return {sin_v * cos_h, sin_v * sin_h, -cos_v};
}

}  // namespace candelabra
