// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/false_colour.h"

#include "base/colour.h"
#include "base/order.h"
#include "film/isolines.h"
#include "film/plate_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace candelabra {

namespace {

/// From dark to light, encoded as sRGB.
constexpr std::array<std::array<double, 3>, 8> scale_colours = {{{0.08, 0.05, 0.22},
                                                                 {0.19, 0.16, 0.48},
                                                                 {0.16, 0.34, 0.62},
                                                                 {0.10, 0.51, 0.60},
                                                                 {0.15, 0.66, 0.48},
                                                                 {0.47, 0.78, 0.30},
                                                                 {0.82, 0.86, 0.22},
                                                                 {1.00, 0.96, 0.62}}};
constexpr std::array<double, 3> beyond = {1.0, 0.45, 0.40}, nothing = {0.35, 0.35, 0.35};
constexpr std::array<double, 3> paper = {1, 1, 1}, ink = {0.1, 0.1, 0.1};

Rgb linear_of(const std::array<double, 3>& encoded) {
    return {srgb_decode(encoded[0]), srgb_decode(encoded[1]), srgb_decode(encoded[2])};
}

Rgb colour_of(double value, double most) {
    if (!std::isfinite(value)) return linear_of(nothing);
    if (value > most) return linear_of(beyond);
    const double place = std::clamp(value / most, 0.0, 1.0) * (scale_colours.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), scale_colours.size() - 2);
    const double share = place - static_cast<double>(below);
    std::array<double, 3> mixed{};
    for (std::size_t c = 0; c < 3; ++c)
        mixed[c] = (1 - share) * scale_colours[below][c] + share * scale_colours[below + 1][c];
    return linear_of(mixed);
}

/// Distance of the marks of a scale: at least five of them, at round numbers.
double step_of(double most) {
    constexpr double least_marks = 5;
    double step = round_upward(most / least_marks);
    if (step * least_marks > most * 1.0001) step = round_upward(step / 2.51);
    return step;
}

std::string number_text(double value) {
    constexpr int digits = 6;
    std::array<char, 40> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                   std::chars_format::general, digits);
    return {text.data(), end.ptr};
}

void add_isolines(const Image& values, double most, Image& picture) {
    IsolineLook look;
    look.size = std::max(1, values.width / 480);
    // Dark lines on light colours, and light ones on dark colours.
    look.colour = [&](double value) { return Rgb(value > 0.55 * most ? 0.02 : 0.8); };
    look.text = number_text;
    const double shortest = 4.0 * letter_height * look.size;
    draw_isolines(isolines_of(calmed(values), step_of(most), most, shortest), look, values.height,
                  picture);
}

void add_scale(Image& picture, int top, double most, const std::string& unit) {
    const int size = std::max(1, picture.width / 480);
    const int margin = 12 * size, bar = 10 * size, left = margin;
    const int right = picture.width - margin - text_width(" " + unit, size) - 8 * size;
    if (right - left < 40) return;
    const int bar_top = top + 6 * size;
    for (int x = left; x < right; ++x) {
        const double value = most * (x - left + 0.5) / (right - left);
        for (int y = bar_top; y < bar_top + bar; ++y) picture.at(x, y) = colour_of(value, most);
    }
    const double step = step_of(most);
    const auto marks = static_cast<int>(std::floor(most / step + 1e-9));
    int free_from = 0;
    for (int i = 0; i <= marks; ++i) {
        const int x = left + static_cast<int>(std::lround((right - left - 1) * (i * step / most)));
        for (int y = bar_top + bar; y < bar_top + bar + 3 * size; ++y)
            picture.at(x, y) = linear_of(ink);
        const std::string text = number_text(i * step);
        const int begin = x - text_width(text, size) / 2;
        if (begin < free_from) continue;
        write_text(picture, {begin, bar_top + bar + 5 * size}, text, size, linear_of(ink));
        free_from = begin + text_width(text, size) + 4 * size;
    }
    write_text(picture, {right + 8 * size, bar_top + 2 * size}, unit, size, linear_of(ink));
}

}  // namespace

double round_upward(double value) {
    double power = 1;
    while (power > value) power /= 10;
    while (power * 10 <= value) power *= 10;
    constexpr double rounding = 1 - 1e-12;
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= rounding * value) return factor * power;
    return 10 * power;
}

double fitting_scale(const Image& values) {
    std::vector<double> sorted;
    for (const Rgb& pixel : values.pixels)
        if (std::isfinite(pixel.r)) sorted.push_back(pixel.r);
    if (sorted.empty()) return 1;
    const auto high = sorted.begin() + static_cast<std::ptrdiff_t>(0.99 * (sorted.size() - 1));
    put_nth(sorted.begin(), high, sorted.end());
    constexpr double least = 1e-6, most = 1e12;
    return *high > least ? round_upward(std::min(*high, most)) : 1;
}

Image false_coloured(const Image& values, const FalseColours& wanted) {
    const double most = wanted.most > 0 ? wanted.most : fitting_scale(values);
    const int strip = 34 * std::max(1, values.width / 480);
    Image picture(values.width, values.height + strip);
    std::ranges::fill(picture.pixels, linear_of(paper));
    for (int y = 0; y < values.height; ++y)
        for (int x = 0; x < values.width; ++x)
            picture.at(x, y) = colour_of(values.at(x, y).r, most);
    if (wanted.isolines) add_isolines(values, most, picture);
    add_scale(picture, values.height, most, wanted.unit);
    return picture;
}

}  // namespace candelabra
