// SPDX-License-Identifier: GPL-3.0-or-later
// A picture with less noise: means over pixels around that show the same surface in the same light,
// as far as their samples can tell. It comes beside the exact picture and becomes it as samples
// grow, because what differs truly is told apart then.
#pragma once

#include "base/image.h"

#include <vector>

namespace candelabra {

/// What is known of each pixel.
struct NoisyPicture {
    Image light;                    ///< means of the samples
    Image variance;                 ///< of these means, of each channel
    Image albedo;                   ///< of the first surfaces; black where there are none
    Image normal;                   ///< the same
    std::vector<double> depth;      ///< of what the pixel's middle shows; infinite: nothing
    std::vector<Image> parts = {};  ///< of the light, such as that of each lamp
};

struct QuietPicture {
    Image light;
    /// With the same weights: what was their sum is so still.
    std::vector<Image> parts;
};

/// Non-local means of the light divided by the albedo, by the distance of F. Rousselle et al.,
/// "Adaptive rendering with non-local means filtering" (2012): squares around two pixels are
/// compared in units of their variance, so that differences that noise explains do not count. What
/// differs in albedo, normal or depth has less weight. Where there is no variance, as with one
/// sample, nothing is changed. The result does not depend on the number of threads.
QuietPicture denoised(const NoisyPicture&, int threads);

}  // namespace candelabra
