// SPDX-License-Identifier: GPL-3.0-or-later
// Develops the radiance on the film to a picture for display. The program does this when it writes
// a picture, and `candelabra develop` with the radiance in an OpenEXR file. Both start from the
// same numbers, so they make the same bytes.
#pragma once

#include "base/image.h"
#include "camera/film_settings.h"
#include "film/white_balance.h"

#include <vector>

namespace candelabra {

/// The undeveloped radiance on the film: linear, as the scene gives it.
struct Negative {
    Image light;
    /// The mean of compressed samples, expanded; no pixels: same as `light`.
    Image smooth;
    /// Per pixel; the light is premultiplied by it. Empty: opaque.
    std::vector<double> alpha;
};

/// Compresses a sample to less than 1 / factor in its greatest channel; expanded() is the inverse
/// for a mean of such samples. Where a lamp covers half a pixel, the result is about 1 / factor,
/// however bright the lamp.
Rgb compressed(const Rgb& sample, double factor);
Rgb expanded(const Rgb& mean, double factor);

/// Returns the exposure in stops, including automatic exposure.
double exposure_of(const Negative&, const FilmSettings&);

/// Returns the factor on the light at a distance from the centre of the picture, where corners are
/// at a distance of 1. It is the fourth power of a cosine, scaled to the fraction that corners
/// lose.
double vignetted(double share, double distance);
/// The same for a pixel.
double vignetted_at(double share, int width, int height, int x, int y);

/// Returns the value of a pixel of many grains, each developed or not. Its mean is `shown`, its
/// standard deviation size * sqrt(shown * (1 - shown)). `chance`: a random number with mean 0 and
/// deviation 1.
double grained(double shown, double size, double chance);

/// Returns light with another contrast: each channel to the power of `contrast`, with a grey of
/// 0.18 kept. Negative light becomes 0 unless the contrast is 1.
Rgb contrasted(const Rgb& light, double contrast);

/// Returns a displayed colour at another distance from the grey of its luminance, within 0 and 1.
Rgb saturated(const Rgb& shown, double saturation);

/// Maps the light in the pixels of a picture of some size to what a display shows of it, as
/// develop() does after the glare.
class PixelDeveloper {
public:
    /// `stops`: the exposure; see exposure_of(). The film must be on, and outlive it.
    PixelDeveloper(const FilmSettings& film, double stops, int width, int height);

    /// `light` is premultiplied by alpha, which is from 0 to 1.
    Rgb operator()(const Rgb& light, double alpha, int x, int y) const;

private:
    const FilmSettings& film_;
    int width_, height_;
    ResponseCurve curve_;
    double exposure_;  ///< a factor
    ColourMatrix balance_;
};

/// Returns linear red, green and blue for a display, from 0 to 1. Applies glare, vignette,
/// exposure, white balance, contrast, response, saturation and grain, in this order. Values have
/// single precision, as in files. Precondition: the film is on. The result does not depend on the
/// number of threads.
Image develop(Negative, const FilmSettings&, int threads);

}  // namespace candelabra
