// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/idle_lights.h"

#include "base/gamma.h"
#include "film/film.h"
#include "output/film_images.h"
#include "output/layers.h"
#include "output/light_report.h"
#include "text/message.h"
#include "world/world.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace candelabra {

namespace {

/// The values that a display shows of a picture, from 0 to 1.
Image displayed(Image light, const FilmFiles& files) {
    double gamma = files.format.gamma;
    if (files.film.on) {
        light = develop({std::move(light), {}, {}}, files.film, files.threads);
        gamma = 1;
    }
    for (Rgb& pixel : light.pixels)
        for (int c = 0; c < 3; ++c)
            pixel[c] = from_linear(to_linear(std::clamp(pixel[c], 0.0, 1.0), gamma), srgb_gamma);
    return light;
}

/// The film with the exposure that the picture has, and nothing by chance.
FilmFiles with_steady_film(FilmFiles files, const Image& light) {
    files.film.exposure = exposure_of({light, {}, {}}, files.film);
    files.film.auto_exposure = false;
    files.film.grain = 0;
    return files;
}

}  // namespace

std::vector<double> changes_without(const Film& film, const FilmFiles& given) {
    const Image light = film.image();
    const FilmFiles files = given.film.on ? with_steady_film(given, light) : given;
    const Image whole = displayed(light, files);
    std::vector<double> changes(files.lights.size());
    for (std::size_t k = 0; k < changes.size(); ++k) {
        Image rest = light;
        const Image off = light_image(film, files, k);
        for (std::size_t i = 0; i < rest.pixels.size(); ++i) rest.pixels[i] -= off.pixels[i];
        rest = displayed(std::move(rest), files);
        for (std::size_t i = 0; i < rest.pixels.size(); ++i)
            changes[k] = std::fmax(changes[k], max_abs_component(whole.pixels[i] - rest.pixels[i]));
    }
    return changes;
}

std::string idle_lights_report(const World& world, const std::vector<double>& changes,
                               const SourceStore& sources) {
    std::string text;
    for (std::size_t k = 0; k < changes.size(); ++k)
        if (changes[k] < 1.0 / 255)
            text += message("could be off, since no pixel changes by 1/255 without it: ",
                            statement_text(world.provenance.light_statements[k], sources), '\n');
    return text;
}

}  // namespace candelabra
