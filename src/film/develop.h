// SPDX-License-Identifier: GPL-3.0-or-later
// From the light on the film to a picture that people look at. The program does this when it writes
// a picture, and `candelabra develop` with the light that an OpenEXR file has kept: by the same
// numbers, so that both make the same bytes.
#pragma once

#include "base/image.h"
#include "camera/film_settings.h"

#include <vector>

namespace candelabra {

/// The light on the film, before it is developed: linear, as the scene gives it.
struct Negative {
    Image light;
    /// The same with samples that were compressed before they were averaged; no pixels: as `light`.
    Image smooth;
    /// Of each pixel, by which its light has been multiplied; empty: all is opaque.
    std::vector<double> alpha;
};

/// Compresses a sample to less than 1 / factor in its greatest channel, and the inverse for a mean
/// of such samples. Half of a lamp's edge is then as bright as 1 / factor, however bright the lamp.
Vec3 compressed(const Vec3& sample, double factor);
Vec3 expanded(const Vec3& mean, double factor);

/// In stops, with those that the picture itself asks for.
double exposure_of(const Negative&, const FilmSettings&);

/// The factor of the light at a place, from the middle of the picture, where the corners are at a
/// distance of 1: the fourth power of a cosine, scaled to the share that corners lose.
double vignetted(double share, double distance);

/// What a pixel of many grains shows, each of which is developed or not: its mean is `shown`, its
/// deviation size * sqrt(shown * (1 - shown)). `chance`: with a mean of 0 and a deviation of 1.
double grained(double shown, double size, double chance);

/// Linear red, green and blue for a display, 0 to 1: glare, vignette, exposure, white balance,
/// response, grain, in this order. Values are those of single precision, as files keep them.
/// Precondition: the film is on. The result does not depend on the number of threads.
Image develop(const Negative&, const FilmSettings&, int threads);

}  // namespace candelabra
