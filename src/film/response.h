// SPDX-License-Identifier: GPL-3.0-or-later
// Response curves from unbounded exposure to display values. All of them preserve a grey of 0.18.
#pragma once

#include "base/rgb.h"
#include "camera/film_settings.h"

namespace candelabra {

/// Returns linear red, green and blue for a display, from 0 to 1, for an unbounded exposure. NaN
/// becomes 0.
///
/// linear: clipped.
/// filmic: the curve of J. Hable, "Uncharted 2: HDR Lighting" (GDC 2010), applied to each channel;
/// 21 times the exposure of the grey and more is white.
/// agx: after T. Sobotka's AgX. Channels are mixed, so that each saturated light has some of all.
/// Their logarithms, from 10 stops below the grey to 6.5 above, go through a curve with a toe and a
/// shoulder. Half of the mixing is then undone. The result is blended with the colour that has the
/// curve's value in its greatest channel and the proportions of the light; its share falls from 0.7
/// to half of that at an exposure of 16. So small saturated lamps keep their colour, and very
/// bright lights become white whatever their colour.
Rgb respond(ResponseCurve, const Rgb& exposure);

/// The numbers of agx. Shares of each channel that are mixed from all channels before the curve and
/// unmixed after it; the greatest share of the colour that has the proportions of the light; the
/// exposure of the greatest channel at which it is half of that.
struct AgxMixing {
    double mixed_in = 0.2, taken_back = 0.1;
    double kept_in_proportion = 0.7, half_kept_exposure = 16;
};
inline constexpr AgxMixing agx_mixing;

/// One channel of the filmic and agx curves.
double filmic_curve(double exposure);
double agx_curve(double exposure);

}  // namespace candelabra
