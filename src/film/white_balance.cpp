// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/white_balance.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace candelabra {

namespace {

using Mat3 = glm::dmat3;

/// glm counts columns first.
Mat3 rows(const Vec3& a, const Vec3& b, const Vec3& c) { return glm::transpose(Mat3(a, b, c)); }

/// Light of luminance 1.
Vec3 xyz_of(Vec2 chromaticity) {
    const double x = chromaticity.x, y = chromaticity.y;
    return {x / y, 1, (1 - x - y) / y};
}

/// From linear sRGB (IEC 61966-2-1) to CIE XYZ.
Mat3 srgb_to_xyz() {
    return rows({0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505});
}

Mat3 bradford() {
    return rows({0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296});
}

}  // namespace

Vec2 black_body_chromaticity(double kelvins) {
    const double t = kelvins, tt = t * t;
    const double u = (0.860117757 + 1.54118254e-4 * t + 1.28641212e-7 * tt) /
                     (1 + 8.42420235e-4 * t + 7.08145163e-7 * tt),
                 v = (0.317398726 + 4.22806245e-5 * t + 4.20481691e-8 * tt) /
                     (1 - 2.89741816e-5 * t + 1.61456053e-7 * tt);
    const double scale = 2 * u - 8 * v + 4;
    return {3 * u / scale, 2 * v / scale};
}

ColourMatrix white_balance(double kelvins) {
    if (kelvins <= 0) return {};
    const Mat3 to_xyz = srgb_to_xyz(), to_cones = bradford();
    const Vec3 light = to_cones * xyz_of(black_body_chromaticity(kelvins));
    const Vec3 white = to_cones * (to_xyz * Vec3(1));
    const Vec3 gains = white / light;
    const Mat3 adapted =
        rows({gains.x, 0, 0}, {0, gains.y, 0}, {0, 0, gains.z}) * to_cones * to_xyz;
    const Mat3 made = glm::transpose(glm::inverse(to_cones * to_xyz) * adapted);
    return {made[0], made[1], made[2]};
}

}  // namespace candelabra
