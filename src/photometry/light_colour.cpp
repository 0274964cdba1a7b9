// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/light_colour.h"

#include "base/elementary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace candelabra {

namespace {

/// Lumens per watt at 540 THz, by which the candela is defined.
constexpr double most_efficacy = 683;

constexpr double first_wavelength = min_wavelength, step = 5;
/// Colour matching functions of the 2 degree observer of CIE 1931, every 5 nanometres.
constexpr std::array<std::array<double, 3>, 81> observer = {{
    {{0.001368, 3.9e-05, 0.00645}}, {{0.002236, 6.4e-05, 0.01055}}, {{0.004243, 0.00012, 0.02005}},
    {{0.00765, 0.000217, 0.03621}}, {{0.01431, 0.000396, 0.06785}}, {{0.02319, 0.00064, 0.1102}},
    {{0.04351, 0.00121, 0.2074}},   {{0.07763, 0.00218, 0.3713}},   {{0.13438, 0.004, 0.6456}},
    {{0.21477, 0.0073, 1.03905}},   {{0.2839, 0.0116, 1.3856}},     {{0.3285, 0.01684, 1.62296}},
    {{0.34828, 0.023, 1.74706}},    {{0.34806, 0.0298, 1.7826}},    {{0.3362, 0.038, 1.77211}},
    {{0.3187, 0.048, 1.7441}},      {{0.2908, 0.06, 1.6692}},       {{0.2511, 0.0739, 1.5281}},
    {{0.19536, 0.09098, 1.28764}},  {{0.1421, 0.1126, 1.0419}},     {{0.09564, 0.13902, 0.81295}},
    {{0.05795, 0.1693, 0.6162}},    {{0.03201, 0.20802, 0.46518}},  {{0.0147, 0.2586, 0.3533}},
    {{0.0049, 0.323, 0.272}},       {{0.0024, 0.4073, 0.2123}},     {{0.0093, 0.503, 0.1582}},
    {{0.0291, 0.6082, 0.1117}},     {{0.06327, 0.71, 0.07825}},     {{0.1096, 0.7932, 0.05725}},
    {{0.1655, 0.862, 0.04216}},     {{0.22575, 0.91485, 0.02984}},  {{0.2904, 0.954, 0.0203}},
    {{0.3597, 0.9803, 0.0134}},     {{0.43345, 0.99495, 0.00875}},  {{0.51205, 1, 0.00575}},
    {{0.5945, 0.995, 0.0039}},      {{0.6784, 0.9786, 0.00275}},    {{0.7621, 0.952, 0.0021}},
    {{0.8425, 0.9154, 0.0018}},     {{0.9163, 0.87, 0.00165}},      {{0.9786, 0.8163, 0.0014}},
    {{1.0263, 0.757, 0.0011}},      {{1.0567, 0.6949, 0.001}},      {{1.0622, 0.631, 0.0008}},
    {{1.0456, 0.5668, 0.0006}},     {{1.0026, 0.503, 0.00034}},     {{0.9384, 0.4412, 0.00024}},
    {{0.85445, 0.381, 0.00019}},    {{0.7514, 0.321, 0.0001}},      {{0.6424, 0.265, 5e-05}},
    {{0.5419, 0.217, 3e-05}},       {{0.4479, 0.175, 2e-05}},       {{0.3608, 0.1382, 1e-05}},
    {{0.2835, 0.107, 0}},           {{0.2187, 0.0816, 0}},          {{0.1649, 0.061, 0}},
    {{0.1212, 0.04458, 0}},         {{0.0874, 0.032, 0}},           {{0.0636, 0.0232, 0}},
    {{0.04677, 0.017, 0}},          {{0.0329, 0.01192, 0}},         {{0.0227, 0.00821, 0}},
    {{0.01584, 0.005723, 0}},       {{0.011359, 0.004102, 0}},      {{0.008111, 0.002929, 0}},
    {{0.00579, 0.002091, 0}},       {{0.004109, 0.001484, 0}},      {{0.002899, 0.001047, 0}},
    {{0.002049, 0.00074, 0}},       {{0.00144, 0.00052, 0}},        {{0.001, 0.000361, 0}},
    {{0.00069, 0.000249, 0}},       {{0.000476, 0.000172, 0}},      {{0.000332, 0.00012, 0}},
    {{0.000235, 8.5e-05, 0}},       {{0.000166, 6e-05, 0}},         {{0.000117, 4.2e-05, 0}},
    {{8.3e-05, 3e-05, 0}},          {{5.9e-05, 2.1e-05, 0}},        {{4.2e-05, 1.5e-05, 0}},
}};

Vec3 entry(std::ptrdiff_t i) {
    const auto last = static_cast<std::ptrdiff_t>(observer.size()) - 1;
    const auto& row = observer[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last))];
    return {row[0], row[1], row[2]};
}

/// The functions between the entries of the table, by the cubic through four of them.
Vec3 matching(double nanometres) {
    const double place = (nanometres - first_wavelength) / step, begin = std::floor(place);
    const double t = place - begin;
    const auto i = static_cast<std::ptrdiff_t>(begin);
    const Vec3 found =
        entry(i - 1) * (-t * (t - 1) * (t - 2) / 6) + entry(i) * ((t + 1) * (t - 1) * (t - 2) / 2) +
        entry(i + 1) * (-(t + 1) * t * (t - 2) / 2) + entry(i + 2) * ((t + 1) * t * (t - 1) / 6);
    return glm::max(found, Vec3(0));
}

Vec2 chromaticity(const Vec3& xyz) { return Vec2(xyz) / (xyz.x + xyz.y + xyz.z); }

}  // namespace

Vec2 planck_chromaticity(double kelvin) {
    constexpr double second_radiation_constant = 1.438776877e7;  // nanometres times kelvin
    Vec3 sum(0);
    for (std::size_t i = 0; i < observer.size(); ++i) {
        const double wavelength = first_wavelength + step * static_cast<double>(i);
        // In proportion to the radiance at 560 nm, whose size does not matter.
        const double power = math::pow(wavelength / 560, -5) /
                             math::expm1(second_radiation_constant / (wavelength * kelvin));
        sum += power * entry(static_cast<std::ptrdiff_t>(i));
    }
    return chromaticity(sum);
}

Vec2 daylight_chromaticity(double kelvin) {
    const double t = 1000 / kelvin;
    const double x = kelvin <= 7000 ? ((-4.6070 * t + 2.9678) * t + 0.09911) * t + 0.244063
                                    : ((-2.0064 * t + 1.9018) * t + 0.24748) * t + 0.237040;
    return {x, (-3 * x + 2.870) * x - 0.275};
}

Vec2 spectral_chromaticity(double nanometres) { return chromaticity(matching(nanometres)); }

double spectral_efficacy(double nanometres) { return most_efficacy * matching(nanometres).y; }

Rgb colour_of_chromaticity(const Vec2& xy) {
    const Vec3 xyz(xy.x / xy.y, 1, (1 - xy.x - xy.y) / xy.y);
    const Rgb rgb = max(Rgb(dot(xyz, Vec3(3.2409699, -1.5373832, -0.4986108)),
                            dot(xyz, Vec3(-0.9692436, 1.8759675, 0.0415551)),
                            dot(xyz, Vec3(0.0556301, -0.2039770, 1.0569715))),
                        Rgb(0));
    return rgb / light_luminance(rgb);
}

}  // namespace candelabra
