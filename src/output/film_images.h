// SPDX-License-Identifier: GPL-3.0-or-later
// Images of the sums that a film gathers besides the picture. Called by the writers of files.
#pragma once

#include "base/rgb.h"
#include "film/develop.h"

#include <cstddef>
#include <span>
#include <vector>

namespace candelabra {

class Film;
struct FilmFiles;

/// Returns the light of a statement, by its number. The film must have layers of light.
Image light_image(const Film&, const FilmFiles&, std::size_t statement);

/// Returns the image of compressed samples, which the film must have.
Image smooth_image(const Film&, const FilmFiles&);

/// A denoised film.
struct QuietFilm {
    Image light;
    Image smooth;               ///< see Negative
    std::vector<Image> lights;  ///< light of each statement, if the files have such layers
};

/// Denoises a film, which must have sums of squared samples, and surfaces.
QuietFilm denoised_film(const Film&, const FilmFiles&);

/// Sets the pixels of a row of the undeveloped picture, and their alpha unless that is empty. To be
/// called from the top: it lets go of the film behind it.
void film_row(const Film&, int y, std::span<Rgb> pixels, std::span<double> alpha);

/// Returns the alpha of each pixel of a film that has it.
std::vector<double> alpha_of(const Film&);

/// Returns the picture with its alpha and compressed samples. If the picture is to be developed, it
/// has the values that the layers of a file would have.
Negative negative_of(const Film&, const FilmFiles&);

}  // namespace candelabra
