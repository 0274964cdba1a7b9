// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/white_balance.h"

namespace candelabra {

namespace {

/// From linear sRGB (IEC 61966-2-1) to CIE XYZ.
constexpr ColourMatrix srgb_to_xyz{
    {0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}};

constexpr ColourMatrix bradford{
    {0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}};

ColourMatrix transposed(const ColourMatrix& m) {
    return {{m.red.x, m.green.x, m.blue.x},
            {m.red.y, m.green.y, m.blue.y},
            {m.red.z, m.green.z, m.blue.z}};
}

/// Returns the map that applies b, then a.
ColourMatrix product(const ColourMatrix& a, const ColourMatrix& b) {
    const ColourMatrix columns = transposed(b);
    return {columns(a.red), columns(a.green), columns(a.blue)};
}

ColourMatrix inverse(const ColourMatrix& m) {
    const double volume = dot(m.red, cross(m.green, m.blue));
    return transposed({cross(m.green, m.blue) / volume, cross(m.blue, m.red) / volume,
                       cross(m.red, m.green) / volume});
}

/// Returns XYZ with a luminance of 1.
Vec3 xyz_of(Vec2 chromaticity) {
    const double x = chromaticity.x, y = chromaticity.y;
    return {x / y, 1, (1 - x - y) / y};
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
    const ColourMatrix to_cones = product(bradford, srgb_to_xyz);
    const Vec3 gains = to_cones(Vec3(1)) / bradford(xyz_of(black_body_chromaticity(kelvins)));
    const ColourMatrix adapted{gains.x * to_cones.red, gains.y * to_cones.green,
                               gains.z * to_cones.blue};
    return product(inverse(to_cones), adapted);
}

}  // namespace candelabra
