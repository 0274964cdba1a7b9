// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/develop.h"

#include "base/elementary.h"
#include "base/parallel.h"
#include "base/random.h"
#include "film/auto_exposure.h"
#include "film/glare.h"
#include "film/response.h"
#include "film/white_balance.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace candelabra {

namespace {

void make_single_precision(Image& image) {
    for (Rgb& pixel : image.pixels)
        for (int c = 0; c < 3; ++c) pixel[c] = static_cast<float>(pixel[c]);
}

/// Applies glare. Scattered light comes from the exact samples; light that is not scattered has
/// smooth edges. Takes the images.
Image glared(Negative& negative, const FilmSettings& film, int threads) {
    Image& stays = negative.smooth.pixels.empty() ? negative.light : negative.smooth;
    if (!film.glares || film.glare.share() <= 0 || stays.pixels.empty()) {
        Image made = std::move(stays);
        negative.light = negative.smooth = Image();
        return made;
    }
    const GlareKernel kernel(film.glare, stays.width, stays.height, threads);
    Image made = spread(negative.light, kernel, threads);
    if (&stays != &negative.light)
        for (std::size_t i = 0; i < made.pixels.size(); ++i)
            made.pixels[i] +=
                (1 - kernel.scattered()) * (stays.pixels[i] - negative.light.pixels[i]);
    return made;
}

/// Returns a nearly normal random number for a pixel and channel, with mean 0 and deviation 1: the
/// centred sum of twelve uniform numbers.
double chance_of(int seed, std::size_t pixel, int channel) {
    const std::uint64_t place = mix(mix(static_cast<std::uint64_t>(seed)) + pixel);
    double sum = 0;
    constexpr std::uint64_t count = 12;
    for (std::uint64_t i = 0; i < count; ++i)
        sum += static_cast<double>(mix(place + count * static_cast<std::uint64_t>(channel) + i) >>
                                   11) *
               0x1p-53;
    return sum - 0.5 * count;
}

}  // namespace

Rgb compressed(const Rgb& sample, double factor) {
    const Rgb light = max(sample, Rgb(0));
    const double most = factor * max_component(light);
    // An infinite light becomes 1 / factor.
    if (!(most < 1e30)) return Rgb(std::isnan(most) ? 0 : 1 / factor);
    return light / (1 + most);
}

Rgb expanded(const Rgb& mean, double factor) {
    constexpr double least = 1e-9;
    return mean / std::max(1 - factor * max_component(mean), least);
}

double exposure_of(const Negative& negative, const FilmSettings& film) {
    return film.exposure + (film.auto_exposure ? stops_asked_by(negative.light, film.key) : 0);
}

Rgb contrasted(const Rgb& light, double contrast) {
    if (contrast == 1) return light;
    constexpr double middle_grey = 0.18;
    const auto one = [&](double channel) {
        return channel > 0 ? middle_grey * math::pow(channel / middle_grey, contrast) : 0;
    };
    return {one(light.r), one(light.g), one(light.b)};
}

Rgb saturated(const Rgb& shown, double saturation) {
    if (saturation == 1) return shown;
    const Rgb grey(srgb_luminance(shown));
    return clamp(grey + saturation * (shown - grey), Rgb(0), Rgb(1));
}

double vignetted(double share, double distance) {
    const double fourth_power = 1 / ((1 + distance * distance) * (1 + distance * distance));
    constexpr double lost_in_corners = 0.75;
    return 1 - share * (1 - fourth_power) / lost_in_corners;
}

double vignetted_at(double share, int width, int height, int x, int y) {
    const double right = 2 * (x + 0.5) - width, down = 2 * (y + 0.5) - height;
    const double corner = math::hypot(width, height);
    return vignetted(share, math::hypot(right, down) / corner);
}

double grained(double shown, double size, double chance) {
    return std::clamp(shown + size * std::sqrt(shown * (1 - shown)) * chance, 0.0, 1.0);
}

PixelDeveloper::PixelDeveloper(const FilmSettings& film, double stops, int width, int height)
    : film_(film),
      width_(width),
      height_(height),
      curve_(film.curve()),
      exposure_(math::exp2(stops)),
      balance_(white_balance(film.white_balance)) {}

Rgb PixelDeveloper::operator()(const Rgb& light, double alpha, int x, int y) const {
    const double falls = vignetted_at(film_.vignette, width_, height_, x, y);
    const bool clear = alpha > 0 && alpha < 1;
    const Rgb exposed = balance_(light * (exposure_ * falls));
    const Rgb lit = contrasted(clear ? exposed / alpha : exposed, film_.contrast);
    Rgb shown = saturated(respond(curve_, lit), film_.saturation);
    const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                       static_cast<std::size_t>(x);
    for (int c = 0; c < 3 && film_.grain > 0; ++c)
        shown[c] = grained(shown[c], film_.grain, chance_of(film_.grain_seed, pixel, c));
    return clear ? shown * alpha : shown;
}

Image develop(Negative negative, const FilmSettings& film, int threads) {
    make_single_precision(negative.light);
    make_single_precision(negative.smooth);
    const double stops = exposure_of(negative, film);
    Image image = glared(negative, film, threads);
    const PixelDeveloper developed(film, stops, image.width, image.height);
    run_parallel(static_cast<std::size_t>(image.height), threads, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < image.width; ++x) {
            const std::size_t pixel =
                row * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
            const double alpha = negative.alpha.empty() ? 1 : negative.alpha[pixel];
            image.at(x, y) = developed(image.at(x, y), alpha, x, y);
        }
    });
    return image;
}

}  // namespace candelabra
