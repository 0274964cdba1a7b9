// SPDX-License-Identifier: GPL-3.0-or-later
// An exposure that a picture asks for. It is a function of the picture alone, so that frames of an
// animation may be made in any order and on any machine, and it is continuous and bounded in each
// pixel: frames that look alike are exposed alike, whatever one lamp does.
#pragma once

#include "base/image.h"

namespace candelabra {

/// Luminance of linear sRGB.
double srgb_luminance(const Vec3&);

/// In stops. With the exposure E = 2^stops the mean of E L / (1 + E L), over the luminances L of
/// the pixels, is that of a grey of 0.18: a bright pixel counts as one at most. A dark picture is
/// made lighter by less, and by 4 stops at most, so that night stays night: s stops become
/// 4 (1 - exp(-s / 4)). Never below -20. A pixel that is not a number counts as black.
double stops_asked_by(const Image&);

}  // namespace candelabra
