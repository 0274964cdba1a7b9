// SPDX-License-Identifier: GPL-3.0-or-later
// Antialiasing where nothing is left to chance, as POV-Ray's first method has it: one ray through
// the middle of each pixel, and a square of others where it differs from a pixel beside it.
#pragma once

#include "base/random.h"
#include "render/film.h"
#include "scene/settings.h"

/// When two places of a picture differ.
struct Contrast {
    double threshold;      ///< of the difference, summed over the channels
    double assumed_gamma;  ///< of the colours in the film
    double gamma;          ///< of those that are compared

    /// A colour as it is compared.
    Vec3 shown(const Vec3& colour) const;
};

Contrast contrast_of(const RenderSettings&, double assumed_gamma);

struct ContrastRule {
    Contrast contrast;
    int across;     ///< rays in a row of the square, and rows
    double jitter;  ///< how far rays are moved at random, in parts of the distance between two
};

ContrastRule contrast_rule(const RenderSettings&, double assumed_gamma);

/// Of a pixel that differs from one beside it.
std::uint32_t all_samples(const ContrastRule&);

/// The pixels, row by row, that differ from the one to their left or right, above or below; but
/// what has no samples is black.
std::vector<bool> standing_out(const Film&, const ContrastRule&, int threads);

/// Where the ray of a sample passes its pixel, from the left and upper edge, in pixels.
Vec2 place_in_pixel(const ContrastRule&, const Key&);
