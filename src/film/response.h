// SPDX-License-Identifier: GPL-3.0-or-later
// What a display shows of exposures of any size. All curves leave a grey of 0.18 where it is.
#pragma once

#include "base/vector.h"
#include "camera/film_settings.h"

namespace candelabra {

/// Linear red, green and blue of a display, 0 to 1, of an exposure of any size; not-a-number shows
/// as 0.
///
/// linear: clipped.
/// filmic: the curve that J. Hable gave in "Uncharted 2: HDR Lighting" (GDC 2010), each channel for
/// itself; 21 times the grey's exposure and more is white.
/// agx: after T. Sobotka's AgX: channels are mixed, so that each saturated light has some of all;
/// their logarithms, 10 stops below the grey to 6.5 above, go through a curve with a toe and a
/// shoulder; half of the mixing is taken back. Bright lights become white whatever their colour.
Vec3 respond(ResponseCurve, const Vec3& exposure);

/// One channel of the two curves.
double filmic_curve(double exposure);
double agx_curve(double exposure);

}  // namespace candelabra
