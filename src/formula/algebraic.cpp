// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula/algebraic.h"

#include "formula/parameters.h"

namespace candelabra {

namespace formula {

namespace {

constexpr double root2 = std::numbers::sqrt2;

/// Clamps the value to the limit that a parameter gives.
double within(double value, double limit) { return std::min(limit, std::max(value, -limit)); }

}  // namespace

double algbr_cyl1(const double* arguments) {
    const Parameters a = Parameters(arguments).turned(2);
    const double value = -a.p[0] * (a.xx * std::abs(a.x) - a.xx + a.yy);
    return -std::min(a.p[1], std::max(value, -a.p[1]));
}

double algbr_cyl2(const double* arguments) {
    const Parameters a = Parameters(arguments).turned(2);
    return within(
        -a.p[0] * (2 * square(a.xx) - 3 * a.xx * a.y + a.yy - 2 * a.yy * a.y + square(a.yy)),
        a.p[1]);
}

double algbr_cyl3(const double* arguments) {
    const Parameters a = Parameters(arguments).turned(2);
    return within(-a.p[0] * (square(a.xx) + a.xx * a.yy - 2 * a.xx * a.y - a.x * a.yy + a.yy),
                  a.p[1]);
}

double algbr_cyl4(const double* arguments) {
    const Parameters a = Parameters(arguments).turned(2);
    return within(-a.p[0] * (square(a.xx + a.yy) + 3 * a.xx * a.y - a.yy * a.y), a.p[1]);
}

double bicorn(const double* arguments) {
    const Parameters a(arguments);
    const double r = square(a.p[1]);
    return limited(a.p[0] *
                   (a.yy * (r - a.xx - a.zz) - square(a.xx + a.zz + 2 * a.p[1] * a.y - r)));
}

double bifolia(const double* arguments) {
    const Parameters a(arguments);
    return limited(-a.p[0] * (square(a.sum()) - a.p[1] * (a.xx + a.zz) * a.y));
}

double boy_surface(const double* arguments) {
    const Parameters a(arguments);
    const double q = 1 - a.z, h = a.xx + a.yy;
    const double first = 64 * cube(q) * cube(a.z);
    const double second = -48 * square(q) * a.zz * (3 * h + 2 * a.zz);
    const double third = 12 * q * a.z *
                         (27 * square(h) - 24 * a.zz * h +
                          36 * root2 * a.y * a.z * (a.yy - 3 * a.xx) + 4 * square(a.zz));
    const double fourth =
        (9 * h - 2 * a.zz) * (-81 * square(h) - 72 * a.zz * h +
                              108 * root2 * a.x * a.z * (a.xx - 3 * a.yy) + 4 * square(a.zz));
    return limited(a.p[0] * a.p[1] * (first + second + third + fourth));
}

double crossed_trough(const double* arguments) {
    const Parameters a(arguments);
    return limited(a.p[0] * (a.xx * a.zz - a.y));
}

double cubic_saddle(const double* arguments) {
    const Parameters a(arguments);
    return limited(-a.p[0] * (cube(a.x) - cube(a.y) - a.z));
}

double cushion(const double* arguments) {
    const Parameters a(arguments);
    return limited(a.p[0] * (a.zz * a.xx - square(a.zz) - 2 * a.z * a.xx + 2 * cube(a.z) + a.xx -
                             a.zz - square(a.xx - a.z) - square(a.yy) - 2 * a.xx * a.yy -
                             a.yy * a.zz + 2 * a.yy * a.z + a.yy));
}

double devils_curve(const double* arguments) {
    const Parameters a(arguments);
    return limited(-a.p[0] * (square(a.xx) + 2 * a.xx * a.zz - 0.36 * a.xx - square(a.yy) +
                              0.25 * a.yy + square(a.zz)));
}

double devils_curve_2d(const double* arguments) {
    const Parameters a = Parameters(arguments).turned(3);
    return limited(-a.p[0] * (a.xx * (a.xx - square(a.p[1])) - a.yy * (a.yy - square(a.p[2]))));
}

double dupin_cyclid(const double* arguments) {
    const Parameters a(arguments);
    const double p1 = a.p[1], p2 = square(a.p[2]), p3 = a.p[3], p4 = square(a.p[4]);
    const double r = square(a.p[5]);
    const double outer = p2 - p4 - square(p3 + p1), inner = p2 - p4 - square(p3 - p1);
    const double along = p3 * a.x + a.p[4] * a.y;
    return limited(
        -a.p[0] *
        (outer * inner * square(a.sum()) +
         2 * r * ((p2 + square(p1) - p4 - square(p3)) * (2 * along - r) - 4 * a.p[4] * p2 * a.y) *
             a.sum() +
         4 * square(r) * along * (along - r) + 4 * square(r) * square(p1) * a.yy +
         square(square(r))));
}

/// Omits the constant terms of Enneper's surface, as POV-Ray 3.7 does.
double enneper(const double* arguments) {
    const Parameters a(arguments);
    const double z = std::abs(a.z) < 0.2 ? 0.2 : a.z;
    const double difference = a.yy - a.xx;
    const double u = difference / (2 * z) + 2 * a.zz / 9, w = difference / (4 * z);
    return limited(-a.p[0] * (cube(u) - 6 * square(w)));
}

double folium_surface(const double* arguments) {
    const Parameters a(arguments);
    return limited(a.p[0] *
                   ((a.yy + a.zz) * (1 + (a.p[2] - 4 * a.p[1]) * a.x) + a.xx * (1 + a.p[2])));
}

double folium_surface_2d(const double* arguments) {
    const Parameters a = Parameters(arguments).turned(3);
    return limited(-a.p[0] * (a.yy * (1 + (a.p[2] - 4 * a.p[1]) * a.x) + a.xx * (1 + a.p[2])));
}

double glob(const double* arguments) {
    const Parameters a(arguments);
    const double fourth = square(a.xx);
    return limited(a.p[0] * (0.5 * fourth * a.x + 0.5 * fourth - (a.yy + a.zz)));
}

double heart(const double* arguments) {
    const Parameters a(arguments);
    const double z3 = cube(a.z);
    return limited(-a.p[0] * (cube(2 * a.xx + a.yy + a.zz - 1) - 0.1 * a.xx * z3 - a.yy * z3));
}

double hunt_surface(const double* arguments) {
    const Parameters a(arguments);
    return limited(-a.p[0] *
                   (4 * cube(a.sum() - 13) + 27 * square(3 * a.xx + a.yy - 4 * a.zz - 12)));
}

double hyperbolic_torus(const double* arguments) {
    const Parameters a(arguments);
    const double p = square(a.p[1]), q = square(a.p[2]);
    return limited(-a.p[0] *
                   (square(a.xx) + 2 * a.xx * a.yy - 2 * a.xx * a.zz - 2 * (p + q) * a.xx +
                    square(a.yy) - 2 * a.yy * a.zz + 2 * (p - q) * a.yy + square(a.zz) +
                    2 * (p + q) * a.zz + square(p - q)));
}

double kampyle_of_eudoxus(const double* arguments) {
    const Parameters a(arguments);
    const double q = square(a.p[2]);
    return limited(-a.p[0] * (a.yy + a.zz - q * square(a.xx) + q * square(a.p[1]) * a.xx));
}

double kampyle_of_eudoxus_2d(const double* arguments) {
    const Parameters a = Parameters(arguments).turned(3);
    const double q = square(a.p[2]);
    return limited(-a.p[0] * (a.yy - q * square(a.xx) + q * a.p[2] * a.p[1] * a.xx));
}

double klein_bottle(const double* arguments) {
    const Parameters a(arguments);
    const double q = a.sum() - 2 * a.y - 1;
    return limited(-a.p[0] *
                   ((a.sum() + 2 * a.y - 1) * (square(q) - 8 * a.zz) + 16 * a.x * a.z * q));
}

double kummer_surface_v1(const double* arguments) {
    const Parameters a(arguments);
    return limited(-a.p[0] * (square(a.xx) + square(a.yy) + square(a.zz) - a.sum() - a.xx * a.yy -
                              a.xx * a.zz - a.yy * a.zz + 1));
}

double kummer_surface_v2(const double* arguments) {
    const Parameters a(arguments);
    return limited(-a.p[0] * (square(a.xx) + square(a.yy) + square(a.zz) + a.p[1] * a.sum() +
                              a.p[2] * (a.xx * a.yy + a.xx * a.zz + a.yy * a.zz) +
                              a.p[3] * a.x * a.y * a.z - 1));
}

double lemniscate_of_gerono(const double* arguments) {
    const Parameters a(arguments);
    return limited(-a.p[0] * (square(a.xx) - a.xx + a.yy + a.zz));
}

double lemniscate_of_gerono_2d(const double* arguments) {
    const Parameters a = Parameters(arguments).turned(3);
    const double q = square(a.p[2]);
    return limited(-a.p[0] * (a.yy - q * square(a.p[1]) * a.xx + q * square(a.xx)));
}

double mitre(const double* arguments) {
    const Parameters a(arguments);
    return limited(-a.p[0] * (4 * a.xx * a.sum() - a.yy * (1 - a.yy - a.zz)));
}

double nodal_cubic(const double* arguments) {
    const Parameters a(arguments);
    return limited(-a.p[0] * (cube(a.y) + cube(a.z) - 6 * a.y * a.z));
}

double ovals_of_cassini(const double* arguments) {
    const Parameters a(arguments);
    const double q = square(a.p[1]);
    return limited(-a.p[0] * (square(a.sum() + q) - a.p[3] * q * (a.xx + a.zz) - square(a.p[2])));
}

double parabolic_torus(const double* arguments) {
    const Parameters a(arguments);
    const double p = square(a.p[1]), q = square(a.p[2]);
    return limited(-a.p[0] * (square(a.xx) + 2 * a.xx * a.yy - 2 * a.xx * a.z - (p + q) * a.xx +
                              square(a.yy) - 2 * a.yy * a.z + (p - q) * a.yy + a.zz +
                              (p + q) * a.z + square(p - q)));
}

double paraboloid(const double* arguments) {
    const Parameters a(arguments);
    return limited(-a.p[0] * (a.xx - a.y + a.zz));
}

double pillow(const double* arguments) {
    const Parameters a(arguments);
    return limited(a.p[0] * (square(a.xx) + square(a.yy) + square(a.zz) - a.sum()));
}

double piriform(const double* arguments) {
    const Parameters a(arguments);
    return -limited(-a.p[0] * (square(a.xx) - cube(a.x) + a.yy + a.zz));
}

double piriform_2d(const double* arguments) {
    const Parameters a = Parameters(arguments).turned(4);
    const double q = square(a.p[3]);
    return limited(-a.p[0] * (a.yy - a.p[1] * q * cube(a.x) - a.p[2] * q * square(a.xx)));
}

double quartic_cylinder(const double* arguments) {
    const Parameters a(arguments);
    const double q = square(a.p[2]);
    return limited(-a.p[0] * ((a.xx + a.zz) * a.yy + q * (a.xx + a.zz) - q * square(a.p[1])));
}

double quartic_paraboloid(const double* arguments) {
    const Parameters a(arguments);
    return limited(-a.p[0] * (square(a.xx) + square(a.zz) - a.y));
}

double quartic_saddle(const double* arguments) {
    const Parameters a(arguments);
    return limited(-a.p[0] * (square(a.xx) - square(a.zz) - a.y));
}

double steiners_roman(const double* arguments) {
    const Parameters a(arguments);
    return limited(-a.p[0] * (a.xx * a.yy + a.xx * a.zz + a.yy * a.zz + a.x * a.y * a.z));
}

double strophoid(const double* arguments) {
    const Parameters a(arguments);
    const double q = square(a.p[3]);
    return limited(-a.p[0] * ((a.p[2] - a.x) * (a.yy + a.zz) - q * a.p[1] * a.xx - q * cube(a.x)));
}

double strophoid_2d(const double* arguments) {
    const Parameters a = Parameters(arguments).turned(4);
    const double q = square(a.p[3]);
    return limited(-a.p[0] * ((a.p[2] - a.x) * a.yy - q * a.p[1] * a.xx - q * cube(a.x)));
}

double torus2(const double* arguments) {
    const Parameters a(arguments);
    const double p = square(a.p[1]), q = square(a.p[2]);
    return limited(-a.p[0] * (square(a.sum()) - 2 * (p + q) * (a.xx + a.zz) + 2 * (p - q) * a.yy +
                              square(p - q)));
}

double torus_gumdrop(const double* arguments) {
    const Parameters a(arguments);
    const double across = a.yy + a.zz;
    return limited(-a.p[0] *
                   (4 * (square(a.xx) + square(across)) + 17 * a.xx * across - 20 * a.sum() + 17));
}

double umbrella(const double* arguments) {
    const Parameters a(arguments);
    return limited(-a.p[0] * (a.xx - a.y * a.zz));
}

double witch_of_agnesi(const double* arguments) {
    const Parameters a(arguments);
    return limited(-a.p[0] * (a.p[1] * (a.y - 1) + (a.xx + a.zz) * a.y));
}

double witch_of_agnesi_2d(const double* arguments) {
    const Parameters a = Parameters(arguments).turned(3);
    return limited(-a.p[0] * (square(a.p[1]) * a.y + a.xx * a.y - a.p[2]));
}

}  // namespace formula

}  // namespace candelabra
