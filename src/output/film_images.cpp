// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/film_images.h"

#include "film/denoise.h"
#include "film/film.h"
#include "output/layers.h"

#include <algorithm>
#include <limits>

namespace candelabra {

namespace {

/// Returns the mean of three consecutive sums.
Rgb mean_of(const Film& film, std::size_t pixel, std::size_t first) {
    const PixelSum& sums = film.pixels()[pixel];
    const auto extra = film.extra(pixel).subspan(first, 3);
    return {sums.mean_of(extra[0].value()), sums.mean_of(extra[1].value()),
            sums.mean_of(extra[2].value())};
}

/// Returns the alpha of a pixel of a film that has its sum.
double alpha_at(const Film& film, std::size_t i) {
    const PixelSum& pixel = film.pixels()[i];
    return pixel.weight() > 0 ? 1 - pixel.mean_of(film.extra(i)[0].value()) : 0;
}

}  // namespace

std::vector<double> alpha_of(const Film& film) {
    std::vector<double> alpha(film.pixels().size());
    film.each([&](std::size_t i) { alpha[i] = alpha_at(film, i); });
    return alpha;
}

Image smooth_image(const Film& film, const FilmFiles& files) {
    const std::size_t first = files.aovs().first_smooth();
    const double factor = files.film.exposure_factor();
    Image image(film.width(), film.height());
    film.each([&](std::size_t i) { image.pixels[i] = expanded(mean_of(film, i, first), factor); });
    return image;
}

Image light_image(const Film& film, const FilmFiles& files, std::size_t statement) {
    const std::size_t first = files.aovs().first_light() + 3 * statement;
    Image image(film.width(), film.height());
    film.each([&](std::size_t i) { image.pixels[i] = mean_of(film, i, first); });
    return image;
}

QuietFilm denoised_film(const Film& film, const FilmFiles& files) {
    const Aovs aovs = files.aovs();
    NoisyPicture noisy;
    noisy.light = film.image();
    noisy.glow = noisy.variance = noisy.albedo = noisy.normal = Image(film.width(), film.height());
    noisy.exposure = files.film.exposure_factor();
    if (aovs.lights) noisy.parts.assign(files.lights.size(), noisy.variance);
    for (std::size_t i = 0; i < film.pixels().size(); ++i) {
        noisy.glow.pixels[i] = mean_of(film, i, aovs.first_glow());
        const Rgb mean = noisy.light.pixels[i] - noisy.glow.pixels[i];
        const double samples = film.pixels()[i].samples;
        noisy.variance.pixels[i] =
            max(mean_of(film, i, aovs.first_square()) - mean * mean, Rgb(0)) /
            std::max(samples - 1, 1.0);
        noisy.albedo.pixels[i] = mean_of(film, i, aovs.albedo());
        noisy.normal.pixels[i] = mean_of(film, i, aovs.normal());
        for (std::size_t k = 0; k < noisy.parts.size(); ++k)
            noisy.parts[k].pixels[i] = mean_of(film, i, aovs.first_light() + 3 * k);
        const double depth = film.extra(i)[aovs.depth()].value();
        noisy.depth.push_back(depth > 0 ? depth : std::numeric_limits<double>::infinity());
    }
    // The compressed samples are averaged with the same weights, so that edges stay smooth.
    if (aovs.smooth) noisy.parts.push_back(smooth_image(film, files));
    QuietPicture made = denoised(noisy, files.threads);
    QuietFilm quiet{std::move(made.light), {}, std::move(made.parts)};
    if (aovs.smooth) {
        quiet.smooth = std::move(quiet.lights.back());
        quiet.lights.pop_back();
    }
    return quiet;
}

void film_row(const Film& film, int y, std::span<Rgb> pixels, std::span<double> alpha) {
    if (y < film.first_row() || y >= film.last_row()) {
        std::ranges::fill(pixels, Rgb(0));
        std::ranges::fill(alpha, 0);
        return;
    }
    const std::size_t first = film.index(0, y);
    for (std::size_t x = 0; x < pixels.size(); ++x) {
        pixels[x] = film.pixels()[first + x].mean();
        if (!alpha.empty()) alpha[x] = alpha_at(film, first + x);
    }
    const std::size_t rows = Film::held_pixels / std::max<std::size_t>(pixels.size(), 1) + 1;
    if (static_cast<std::size_t>(y) % rows == 0) film.let_go();
}

Negative negative_of(const Film& film, const FilmFiles& files) {
    if (!is_developed(files))
        return {film.image(), {}, files.alpha ? alpha_of(film) : std::vector<double>()};
    Negative negative{linear(film.image(), files.format), {}, {}};
    if (files.aovs().smooth) negative.smooth = linear(smooth_image(film, files), files.format);
    if (files.alpha)
        for (const double each : alpha_of(film)) negative.alpha.push_back(static_cast<float>(each));
    return negative;
}

}  // namespace candelabra
