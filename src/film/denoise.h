// SPDX-License-Identifier: GPL-3.0-or-later
// Denoises a picture: averages each pixel with pixels nearby that show the same surface in the same
// light, as far as their samples can tell. The result is written beside the exact picture and
// converges to it, since real differences become significant with more samples.
#pragma once

#include "base/image.h"

#include <vector>

namespace candelabra {

/// The inputs: statistics of the samples of each pixel.
struct NoisyPicture {
    Image light;                    ///< means of the samples
    Image glow;                     ///< the part of it that stays as it is; see LightLedger::glow
    Image variance;                 ///< of the means of the rest, per channel
    Image albedo;                   ///< of the first surfaces; black where there is none
    Image normal;                   ///< of the first surfaces; black where there is none
    std::vector<double> depth;      ///< at the centre of the pixel; infinite: nothing there
    std::vector<Image> parts = {};  ///< of the light, such as that of each lamp
    double exposure = 1;            ///< factor on the light for display
};

struct QuietPicture {
    Image light;
    /// Filtered with the same weights, so that sums are preserved. Each keeps the same share of
    /// itself as the light does.
    std::vector<Image> parts;
};

/// Non-local means of the light without its glow, over the albedo. Distance of F. Rousselle et al.,
/// "Adaptive rendering with non-local means filtering" (2012): patches around two pixels are
/// compared relative to their variance, so that differences due to noise do not count; they are
/// compared as a display shows them, so that few bright pixels do not spread. Pixels that
/// differ in albedo, normal or depth have less weight. Pixels without variance, as with one sample,
/// stay unchanged. The result does not depend on the number of threads.
QuietPicture denoised(const NoisyPicture&, int threads);

}  // namespace candelabra
