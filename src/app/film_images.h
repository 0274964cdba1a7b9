// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of what a film has gathered besides the samples' sums. Called by the writers of files.
#pragma once

#include "film/develop.h"

namespace candelabra {

class Film;
struct FilmFiles;

/// Of compressed samples, which the film must have.
Image smooth_image(const Film&, const FilmFiles&);

/// A film with less noise.
struct QuietFilm {
    Image light;
    Image smooth;               ///< see Negative
    std::vector<Image> lights;  ///< of each statement, if the files have layers of it
};

/// The film must have squares of samples, and surfaces.
QuietFilm denoised_film(const Film&, const FilmFiles&);

/// The picture with what belongs to it. If it is to be developed, it has the values that layers of
/// a file would have.
Negative negative_of(const Film&, const FilmFiles&);

}  // namespace candelabra
