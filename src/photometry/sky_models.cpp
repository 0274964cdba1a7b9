// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/sky_models.h"

#include "base/degrees.h"
#include "base/elementary.h"
#include "photometry/light_colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

/// a, b, c, d and e of the types of ISO 15469.
constexpr std::array<std::array<double, 5>, 15> general_skies = {{{4, -0.7, 0, -1, 0},
                                                                  {4, -0.7, 2, -1.5, 0.15},
                                                                  {1.1, -0.8, 0, -1, 0},
                                                                  {1.1, -0.8, 2, -1.5, 0.15},
                                                                  {0, -1, 0, -1, 0},
                                                                  {0, -1, 2, -1.5, 0.15},
                                                                  {0, -1, 5, -2.5, 0.3},
                                                                  {0, -1, 10, -3, 0.45},
                                                                  {-1, -0.55, 2, -1.5, 0.15},
                                                                  {-1, -0.55, 5, -2.5, 0.3},
                                                                  {-1, -0.55, 10, -3, 0.45},
                                                                  {-1, -0.32, 10, -3, 0.45},
                                                                  {-1, -0.32, 16, -3, 0.3},
                                                                  {-1, -0.15, 16, -3, 0.3},
                                                                  {-1, -0.15, 24, -2.8, 0.15}}};

/// What depends on the clearness: four numbers for each of a, b, c, d and e, and four for the
/// efficacy of the sky and of the sun. Perez, Seals and Michalsky 1993; Perez and others 1990.
struct PerezRow {
    double from;  ///< least clearness
    std::array<std::array<double, 4>, 5> shape;
    std::array<double, 4> diffuse, direct;
};
constexpr std::array<PerezRow, 8> perez_rows = {{{1,
                                                  {{{1.3525, -0.2576, -0.269, -1.4366},
                                                    {-0.767, 0.0007, 1.2734, -0.1233},
                                                    {2.8, 0.6004, 1.2375, 1},
                                                    {1.8734, 0.6297, 0.9738, 0.2809},
                                                    {0.0356, -0.1246, -0.5718, 0.9938}}},
                                                  {97.24, -0.46, 12, -8.91},
                                                  {57.2, -4.55, -2.98, 117.12}},
                                                 {1.065,
                                                  {{{-1.2219, -0.773, 1.4148, 1.1016},
                                                    {-0.2054, 0.0367, -3.9128, 0.9156},
                                                    {6.975, 0.1774, 6.4477, -0.1239},
                                                    {-1.5798, -0.5081, -1.7812, 0.108},
                                                    {0.2624, 0.0672, -0.219, -0.4285}}},
                                                  {107.22, 1.15, 0.59, -3.95},
                                                  {98.99, -3.46, -1.21, 12.38}},
                                                 {1.23,
                                                  {{{-1.1, -0.2515, 0.8952, 0.0156},
                                                    {0.2782, -0.1812, -4.5, 1.1766},
                                                    {24.7219, -13.0812, -37.7, 34.8438},
                                                    {-5, 1.5218, 3.9229, -2.6204},
                                                    {-0.0156, 0.1597, 0.4199, -0.5562}}},
                                                  {104.97, 2.96, -5.53, -8.77},
                                                  {109.83, -4.9, -1.71, -8.81}},
                                                 {1.5,
                                                  {{{-0.5484, -0.6654, -0.2672, 0.7117},
                                                    {0.7234, -0.6219, -5.6812, 2.6297},
                                                    {33.3389, -18.3, -62.25, 52.0781},
                                                    {-3.5, 0.0016, 1.1477, 0.1062},
                                                    {0.4659, -0.3296, -0.0876, -0.0329}}},
                                                  {102.39, 5.59, -13.95, -13.9},
                                                  {110.34, -5.84, -1.99, -4.56}},
                                                 {1.95,
                                                  {{{-0.6, -0.3566, -2.5, 2.325},
                                                    {0.2937, 0.0496, -5.6812, 1.8415},
                                                    {21, -4.7656, -21.5906, 7.2492},
                                                    {-3.5, -0.1554, 1.4062, 0.3988},
                                                    {0.0032, 0.0766, -0.0656, -0.1294}}},
                                                  {100.71, 5.94, -22.75, -23.74},
                                                  {106.36, -3.97, -1.75, -6.16}},
                                                 {2.8,
                                                  {{{-1.0156, -0.367, 1.0078, 1.4051},
                                                    {0.2875, -0.5328, -3.85, 3.375},
                                                    {14, -0.9999, -7.1406, 7.5469},
                                                    {-3.4, -0.1078, -1.075, 1.5702},
                                                    {-0.0672, 0.4016, 0.3017, -0.4844}}},
                                                  {106.42, 3.83, -36.15, -28.83},
                                                  {107.19, -1.25, -1.51, -26.73}},
                                                 {4.5,
                                                  {{{-1, 0.0211, 0.5025, -0.5119},
                                                    {-0.3, 0.1922, 0.7023, -1.6317},
                                                    {19, -5, 1.2438, -1.9094},
                                                    {-4, 0.025, 0.3844, 0.2656},
                                                    {1.0468, -0.3788, -2.4517, 1.4656}}},
                                                  {141.88, 1.9, -53.24, -14.03},
                                                  {105.75, 0.77, -1.26, -34.44}},
                                                 {6.2,
                                                  {{{-1.05, 0.0289, 0.426, 0.359},
                                                    {-0.325, 0.1156, 0.7781, 0.0025},
                                                    {31.0625, -14.5, -46.1148, 55.375},
                                                    {-7.2312, 0.405, 13.35, 0.6234},
                                                    {1.5, -0.6426, 1.8564, 0.5636}}},
                                                  {152.23, 0.35, -45.27, -7.98},
                                                  {101.18, 1.58, -1.1, -8.29}}}};

std::size_t row_number(double clearness) {
    std::size_t i = perez_rows.size() - 1;
    while (i > 0 && clearness < perez_rows[i].from) --i;
    return i;
}

/// Irradiance of sunlight outside of the atmosphere, in W/m2, and its illuminance in lux.
constexpr double solar_irradiance = 1367, solar_illuminance = 127500;

/// Formulas of the clearness have this factor on the cube of the sun's zenith angle.
constexpr double kappa = 1.041;

double zenith_angle(double sun_height) { return pi / 2 - sun_height; }

double cubed(double sun_height) {
    const double angle = zenith_angle(sun_height);
    return kappa * angle * angle * angle;
}

}  // namespace

double SkyModel::luminance(double cosine_to_zenith, double cosine_to_sun) const {
    constexpr double least = 1e-6;  // at the horizon, the exponential is 0
    const double gradation = linear ? (1 + 2 * cosine_to_zenith) / 3
                                    : 1 + a * math::exp(b / std::fmax(cosine_to_zenith, least));
    const double angle = math::acos(std::clamp(cosine_to_sun, -1.0, 1.0));
    const double indicatrix =
        1 + c * (math::exp(d * angle) - base) + e * cosine_to_sun * cosine_to_sun;
    return std::fmax(gradation * indicatrix, 0);
}

double SkyModel::illuminance(double sun_height) const {
    constexpr int rings = 256, sectors = 256;
    const auto [up, aside] = math::sin_cos(sun_height);
    double sum = 0;
    for (int j = 0; j < sectors; ++j) {
        const double turned = aside * math::cos(pi * (j + 0.5) / sectors);
        // Rings of equal illuminance; one half of the sky is as the other.
        for (int i = 0; i < rings; ++i) {
            const double square = (i + 0.5) / rings, cosine = std::sqrt(1 - square);
            sum += luminance(cosine, cosine * up + std::sqrt(square) * turned);
        }
    }
    return pi * sum / (rings * sectors);
}

SkyModel cie_sky(int type) {
    constexpr int older_overcast = 16;
    if (type == older_overcast) return {0, 0, 0, 0, 0, 0, true};
    const auto& row = general_skies.at(static_cast<std::size_t>(type - 1));
    return {row[0], row[1], row[2], row[3], row[4], math::exp(row[3] * pi / 2)};
}

PerezWeather PerezWeather::of(const Vec2& irradiance, double sun_height) {
    const double cube = cubed(sun_height), diffuse = std::fmax(irradiance.y, 1e-3);
    return {((diffuse + irradiance.x) / diffuse + cube) / (1 + cube),
            air_mass(sun_height) * diffuse / solar_irradiance};
}

Vec2 PerezWeather::irradiance(double sun_height) const {
    const double diffuse = brightness * solar_irradiance / air_mass(sun_height);
    return {std::fmax(diffuse * (clearness - 1) * (1 + cubed(sun_height)), 0), diffuse};
}

SkyModel perez_sky(const PerezWeather& weather, double sun_height) {
    const std::size_t number = row_number(weather.clearness);
    const double angle = zenith_angle(sun_height);
    double bright = std::clamp(weather.brightness, 0.01, 0.6);
    // The formulas were not fitted to dark skies with some sun, where they go astray.
    if (weather.clearness > 1.065 && weather.clearness < 2.8) bright = std::fmax(bright, 0.2);
    std::array<double, 5> x{};
    for (std::size_t k = 0; k < x.size(); ++k) {
        const auto& row = perez_rows[number].shape[k];
        x[k] = row[0] + row[1] * angle + bright * (row[2] + row[3] * angle);
    }
    if (number == 0) {
        const auto& c = perez_rows[0].shape[2];
        const auto& d = perez_rows[0].shape[3];
        x[2] = math::exp(math::pow(bright * (c[0] + c[1] * angle), c[2])) - c[3];
        x[3] = -math::exp(bright * (d[0] + d[1] * angle)) + d[2] + bright * d[3];
    }
    return {x[0], x[1], x[2], x[3], x[4], 0};
}

Daylighting daylighting(const PerezWeather& weather, const Vec2& irradiance, double sun_height) {
    constexpr double water = 2;
    const PerezRow& row = perez_rows[row_number(weather.clearness)];
    const double bright = std::clamp(weather.brightness, 0.01, 0.6);
    const double angle = zenith_angle(sun_height);
    const double of_sky = row.diffuse[0] + row.diffuse[1] * water +
                          row.diffuse[2] * math::cos(angle) + row.diffuse[3] * math::log(bright);
    const double of_sun = row.direct[0] + row.direct[1] * water +
                          row.direct[2] * math::exp(5.73 * angle - 5) + row.direct[3] * bright;
    return {irradiance.x * std::fmax(of_sun, 0), irradiance.y * std::fmax(of_sky, 0)};
}

Daylighting usual_daylighting(int type, double sun_height, int day) {
    struct Usual {
        double extinction;  // of sunlight, for each air mass; 0: there is none
        double level, range, power;
    };
    constexpr Usual overcast{0, 300, 21000, 1}, partly{0.8, 300, 45000, 1},
        clear{0.21, 800, 15500, 0.5};
    const Usual& usual = type <= 5 || type > 15 ? overcast : type <= 10 ? partly : clear;
    const double sine = math::sin(sun_height);
    // In twilight, each 2.5 degrees leave a tenth of the light.
    if (sine <= 0) return {0, usual.level * math::pow(10, 0.4 * sun_height / radians_per_degree)};
    const double outside = solar_illuminance * (1 + 0.034 * math::cos(2 * pi / 365 * (day - 2)));
    const double direct = usual.extinction > 0 ? outside * math::exp(-usual.extinction / sine) : 0;
    return {direct, usual.level + usual.range * math::pow(sine, usual.power)};
}

double air_mass(double sun_height) {
    const double degrees = std::fmax(sun_height, 0) / radians_per_degree;
    return 1 / (math::sin(degrees * radians_per_degree) +
                0.50572 * math::pow(degrees + 6.07995, -1.6364));
}

Rgb blue_sky_colour(double luminance) {
    const double reciprocal = -132.1 + 59.77 * math::log10(std::fmax(luminance, 1e-3));
    return daylight_colour(1e6 / std::clamp(reciprocal, 1e6 / max_daylight, 1e6 / min_daylight));
}

Rgb sun_colour(double sun_height) {
    // Rayleigh scattering, and haze of 0.05 by Angstrom's formula, at the wavelengths of Rec. 709
    // in micrometres.
    constexpr std::array wavelengths = {0.61, 0.55, 0.465};
    constexpr double outside = 5778, haze = 0.05;
    const double mass = air_mass(sun_height);
    Rgb colour = planck_colour(outside);
    for (int i = 0; i < 3; ++i) {
        const double length = wavelengths[static_cast<std::size_t>(i)];
        const double depth = 0.008735 * math::pow(length, -4.08) + haze * math::pow(length, -1.3);
        colour[i] *= math::exp(-mass * depth);
    }
    return colour / light_luminance(colour);
}

}  // namespace candelabra
