// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula/solid.h"

#include "base/degrees.h"
#include "base/elementary.h"
#include "formula/parameters.h"

#include <array>
#include <limits>

namespace candelabra {

namespace formula {

namespace {

/// Returns three Gaussian bells whose level sets are ellipsoids. Each has scale p0 along two axes
/// and 1 along the third; p1 is the steepness.
std::array<double, 3> bells(const Parameters& a) {
    const double thin = a.p[0], steep = a.p[1];
    return {math::exp(-steep * (thin * (a.xx + a.yy) + a.zz)),
            math::exp(-steep * (thin * (a.xx + a.zz) + a.yy)),
            math::exp(-steep * (thin * (a.yy + a.zz) + a.xx))};
}

/// Position in a hexagonal tiling of the plane: the absolute offsets from the nearest centre.
struct HexagonPlace {
    double x, y;
    bool sideways;  ///< the nearest border is one of the upright ones
};

HexagonPlace hexagon_place(const Parameters& a) {
    const double width = std::numbers::sqrt3 / 2;
    double x = std::abs(std::fmod(std::abs(a.x), std::numbers::sqrt3) - width);
    double y = std::abs(std::fmod(std::abs(a.y), 3) - 1.5);
    if (x * x + y * y > square(width - x) + square(1.5 - y)) {
        x = width - x;
        y = 1.5 - y;
    }
    return {x, y, math::atan2(y, x) < pi / 6};
}

/// Distance from a point of the plane to the nearest of `parts` points, which are spread evenly
/// over a circle around the origin, starting at the z axis.
double to_nearest_on_circle(double x, double z, double radius, double parts) {
    const double last = std::trunc(parts) - 1;
    if (!(last >= 0)) return 10000;
    const double step = 2 * pi / parts;
    // The distance grows with the difference of the angles, so only the neighbours can be nearest.
    const double at = wrapped(radius < 0 ? math::atan2(-x, -z) : math::atan2(x, z), 2 * pi) / step;
    double nearest = std::numeric_limits<double>::infinity();
    for (const double candidate : {0.0, std::floor(at), std::ceil(at), last}) {
        const double angle = std::clamp(candidate, 0.0, last) * step;
        nearest = std::min(nearest, std::sqrt(square(x - radius * math::sin(angle)) +
                                              square(z - radius * math::cos(angle))));
    }
    return nearest;
}

}  // namespace

double blob(const double* arguments) {
    const Parameters a(arguments);
    const auto part = [&](double x, double closeness) {
        return square(1 - std::min(1.0, (square(x) + a.yy + a.zz) * square(closeness)));
    };
    return -(a.p[1] * part(a.x + a.p[0] / 2, a.p[2]) + a.p[3] * part(a.x - a.p[0] / 2, a.p[4]));
}

double blob2(const double* arguments) {
    const Parameters a(arguments);
    return a.p[3] - a.p[2] * (math::exp(-a.p[1] * a.sum()) +
                              math::exp(-a.p[1] * (square(a.x - a.p[0]) + a.yy + a.zz)));
}

double comma(const double* arguments) {
    const Parameters a(arguments);
    const double x = a.x == 0 && a.z == 0 ? 1e-4 : a.x;
    const double half = a.p[0] / 2;
    const double along = std::sqrt(square(x + half / 2) + a.zz);
    const double tail = std::min(a.z, half * math::cos(math::atan2(a.z, x) / 2) -
                                          std::sqrt(square(along - 1.5 * half) + a.yy));
    return -std::max(tail, half - std::sqrt(square(x - half) + a.zz + a.yy));
}

double cross_ellipsoids(const double* arguments) {
    const Parameters a(arguments);
    return a.p[3] - a.p[2] * std::ranges::max(bells(a));
}

double ellipsoid(const double* arguments) {
    const Parameters a(arguments);
    return std::sqrt(square(a.p[0]) * a.xx + square(a.p[1]) * a.yy + square(a.p[2]) * a.zz);
}

double flange_cover(const double* arguments) {
    const Parameters a(arguments);
    const auto bell = bells(a);
    return a.p[3] - a.p[2] * (bell[0] + bell[1] + bell[2]);
}

double helical_torus(const double* arguments) {
    const Parameters a(arguments);
    const double around = std::sqrt(a.xx + a.zz);
    const double phi = math::atan2(a.xx + a.zz == 0 ? 1e-6 : a.x, a.z);
    const double psi = math::atan2(around - a.p[0], a.y);
    const double away = std::sqrt(square(around - a.p[0]) + a.yy);
    const double theta = wrapped(phi * a.p[1] + psi * a.p[2], 2 * pi) - pi;
    const double winding = math::atan2(theta * a.p[8], away - a.p[5]);
    double body = a.p[3] * math::cos(winding * a.p[7] + phi * a.p[9]) + a.p[4];
    body -= std::min(std::sqrt(square(away - a.p[5]) + a.p[6] * square(theta)), away + a.p[5]);
    return -std::max(a.p[4] + a.p[5] - a.p[0] - around, body);
}

double helix1(const double* arguments) {
    const Parameters a(arguments);
    const double away = std::sqrt(a.xx + a.zz);
    const double theta = wrapped(a.p[0] * math::atan2(a.z, a.x) + a.p[0] * a.p[1] * a.y, 2 * pi);
    double u = away - a.p[3], w = (theta - pi) / (a.p[4] * a.p[1] * a.p[0]);
    if (a.p[5] != 1 && a.p[6] != 0) {
        const double angle = a.p[6] * radians_per_degree, cosine = math::cos(angle),
                     sine = math::sin(angle);
        const double turned = u * cosine - w * sine;
        w = u * sine + w * cosine;
        u = turned;
    }
    return -a.p[2] + std::min(a.p[3] + away, cross_section(u, w, a.p[5]));
}

double helix2(const double* arguments) {
    const Parameters a(arguments);
    const double cosine = math::cos(a.p[1] * a.y), sine = math::sin(a.p[1] * a.y);
    const double x = a.x - a.p[3] * cosine, z = a.z - a.p[3] * sine;
    return cross_section(x * cosine + z * sine, -x * sine + z * cosine, a.p[5]) - a.p[2];
}

double hex_x(const double* arguments) {
    const HexagonPlace h = hexagon_place(Parameters(arguments));
    return h.sideways ? h.x : h.x / 2 + std::numbers::sqrt3 / 2 * h.y;
}

double hex_y(const double* arguments) {
    const HexagonPlace h = hexagon_place(Parameters(arguments));
    return h.sideways ? h.y : std::abs(h.y / 2 - std::numbers::sqrt3 / 2 * h.x);
}

double isect_ellipsoids(const double* arguments) {
    const Parameters a(arguments);
    return a.p[3] - a.p[2] * std::ranges::min(bells(a));
}

double mesh1(const double* arguments) {
    const Parameters a(arguments);
    const double px = a.p[0], pz = a.p[1];
    const auto up_and_down = [&](double along, double period) {
        return a.p[2] * std::abs(wrapped(along, 2 * period) - period);
    };
    const auto thread = [&](double wave, double across) {
        return std::sqrt(square((a.y + wave * a.p[3]) * a.p[4]) + square(across));
    };
    const double wave_z = math::cos(pi * a.z / pz), wave_x = math::cos(pi * a.x / px);
    return std::min(
        std::min(thread(-wave_z, up_and_down(a.x, px)), thread(wave_z, up_and_down(a.x - px, px))),
        std::min(thread(wave_x, up_and_down(a.z, pz)), thread(-wave_x, up_and_down(a.z - pz, pz))));
}

double ph(const double* arguments) {
    const Parameters a(arguments);
    return math::atan2(std::sqrt(a.xx + a.zz), a.y);
}

double poly4(const double* arguments) {
    const Parameters a(arguments);
    const double radius =
        a.p[0] + a.p[1] * a.y + a.p[2] * a.yy + a.p[3] * cube(a.y) + a.p[4] * square(a.yy);
    return std::sqrt(a.xx + a.zz) - std::max(-5.0, radius);
}

double polytubes(const double* arguments) {
    const Parameters a(arguments);
    const double radius =
        a.p[1] + a.p[2] * a.y + a.p[3] * a.yy + a.p[4] * cube(a.y) + a.p[5] * square(a.yy);
    return to_nearest_on_circle(a.x, a.z, radius, a.p[0]);
}

/// Roughly the probability cloud of the electron in a hydrogen atom.
double quantum(const double* arguments) {
    const Parameters a(arguments);
    const double x = a.x == 0 && a.z == 0 ? 1e-6 : a.x;
    const double cosine = math::cos(math::atan2(std::sqrt(square(x) + a.zz), a.y));
    const double radius = 2 * std::sqrt(square(x) + a.yy + a.zz);
    const double wave = square(radius) * math::exp(-0.33333333 * radius) * (3 * square(cosine) - 1);
    return -0.1 * (square(wave) - 12);
}

double r(const double* arguments) { return std::sqrt(Parameters(arguments).sum()); }

double rounded_box(const double* arguments) {
    const Parameters a(arguments);
    const auto outside = [&](double along, double size) {
        return std::max(0.0, std::abs(along) - (size - a.p[0]));
    };
    return std::sqrt(square(outside(a.x, a.p[1])) + square(outside(a.y, a.p[2])) +
                     square(outside(a.z, a.p[3]))) -
           a.p[0] - 1e-6;
}

double sphere(const double* arguments) {
    const Parameters a(arguments);
    return std::sqrt(a.sum()) - a.p[0];
}

double spikes(const double* arguments) {
    const Parameters a(arguments);
    const auto bell = bells(a);
    return -a.p[2] * (a.p[4] * math::exp(-a.p[3] * a.sum()) - bell[0] - bell[1] - bell[2]);
}

double spikes_2d(const double* arguments) {
    const Parameters a(arguments);
    return a.y - a.p[0] * math::cos(a.p[1] * a.x) * math::cos(a.p[2] * a.z) *
                     math::exp(-a.p[3] * (a.xx + a.zz));
}

/// POV-Ray 3.7 ignores parameters p3 and p4.
double spiral(const double* arguments) {
    const Parameters a(arguments);
    const double away = std::sqrt(a.xx + a.zz) + a.p[0] * math::atan2(a.z, a.x) / (2 * pi);
    const double between = std::fmod(away, a.p[0]) - a.p[0] / 2;
    const double tube = cross_section(between, a.y, a.p[5]);
    const double radius = std::sqrt(a.sum());
    return -std::min(a.p[2] - radius, a.p[1] - std::min(tube, radius));
}

double superellipsoid(const double* arguments) {
    const Parameters a(arguments);
    const double east = 2 / a.p[0], north = 2 / a.p[1];
    const double ring =
        math::pow(math::pow(std::abs(a.x), east) + math::pow(std::abs(a.y), east), a.p[0] / a.p[1]);
    return 1 - math::pow(ring + math::pow(std::abs(a.z), north), a.p[1] / 2);
}

double th(const double* arguments) { return math::atan2(arguments[0], arguments[2]); }

double torus(const double* arguments) {
    const Parameters a(arguments);
    return std::sqrt(square(std::sqrt(a.xx + a.zz) - a.p[0]) + a.yy) - a.p[1];
}

}  // namespace formula

}  // namespace candelabra
