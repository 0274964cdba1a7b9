// SPDX-License-Identifier: GPL-3.0-or-later
#include "meter/glare.h"

#include "base/degrees.h"
#include "base/elementary.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

/// The angle between two unit vectors in degrees, exact also if it is small.
double degrees_between(const Vec3& a, const Vec3& b) {
    return math::atan2(length(cross(a, b)), dot(a, b)) / radians_per_degree;
}

}  // namespace

double guth_index(const Sightline& sight, const Vec3& direction) {
    constexpr double greatest = 16;
    const double beta = degrees_between(sight.ahead, direction);
    if (!(beta < 90)) return 0;
    const Vec3 upward = unit(sight.up - dot(sight.up, sight.ahead) * sight.ahead);
    const Vec3 aside = direction - dot(direction, sight.ahead) * sight.ahead;
    if (aside == Vec3(0)) return 1;
    const double alpha = degrees_between(upward, unit(aside));
    if (alpha > 90) {
        // Below the line of sight.
        constexpr double flattening = 0.3225;
        const double across = math::cos(alpha * radians_per_degree);
        const double tangent =
            math::tan(beta * radians_per_degree) * std::sqrt(1 + flattening * across * across);
        const double lowered = math::atan2(tangent, 1) / radians_per_degree;
        return std::fmin(math::exp(6.49e-3 * lowered + 21e-5 * lowered * lowered), greatest);
    }
    const double linear = 35.2 - 0.31889 * alpha - 1.22 * math::exp(-2 * alpha / 9);
    const double square = 21 + 0.26667 * alpha - 0.002963 * alpha * alpha;
    return std::fmin(math::exp(linear * 1e-3 * beta + square * 1e-5 * beta * beta), greatest);
}

double unified_glare_rating(double background, double sources) {
    if (!(sources > 0)) return 0;
    return std::fmax(8 * math::log10(0.25 / background * sources), 0);
}

double veil_factor(const Sightline& sight, const Vec3& direction) {
    constexpr double nearest = 1.5, farthest = 60, roof = 20, of_age = 9.86, old = 66.4, age = 23;
    const double theta = degrees_between(sight.ahead, direction);
    if (!(theta > nearest && theta < farthest)) return 0;
    const Vec3 forward = unit(sight.ahead - dot(sight.ahead, sight.up) * sight.up);
    const double height =
        math::atan2(dot(direction, sight.up), dot(direction, forward)) / radians_per_degree;
    if (height > roof) return 0;
    const double share = age / old;
    return of_age * (1 + share * share * share * share) / (theta * theta);
}

double threshold_increment(double veil, double road) {
    constexpr double bright = 5;
    return road > bright ? 95 * veil / math::pow(road, 1.05) : 65 * veil / math::pow(road, 0.8);
}

}  // namespace candelabra
