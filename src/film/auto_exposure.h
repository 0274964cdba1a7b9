// SPDX-License-Identifier: GPL-3.0-or-later
// Automatic exposure of a picture. It is a function of the picture alone, so that frames of an
// animation may be made in any order and on any machine. It is continuous and bounded in each
// pixel, so that similar frames are exposed alike, whatever a single lamp does.
#pragma once

#include "base/image.h"

namespace candelabra {

/// Returns the luminance of a linear sRGB colour.
double srgb_luminance(const Rgb&);

/// Returns the exposure in stops. With E = 2^stops, the mean of E L / (1 + E L) over the luminances
/// L of the pixels is that of a grey of luminance `key`, so each pixel counts as one at most. Dark
/// pictures are brightened less, and by 4 stops at most, so that night stays night: s stops become
/// 4 (1 - exp(-s / 4)). The result is never below -20. NaN pixels count as black.
double stops_asked_by(const Image&, double key);

}  // namespace candelabra
