// SPDX-License-Identifier: GPL-3.0-or-later
// Hypercomplex Julia fractals whose function is a formula of complex numbers: `sin`, `exp`, `pwr`
// and so on. Two errors of POV-Ray 3.7, visible in all existing pictures, are reproduced. First,
// the orbit of a different point, whose z equals its y, decides whether a point is in the set; but
// rays search for the set with the orbits of the points themselves. Second, the gradient is
// computed with the point itself in place of the function's first derivative, and with values of
// the function in place of the others; for 1 / q, only the first one is replaced.
#pragma once

#include "shape/julia_orbit.h"

namespace candelabra {

/// The function; any fractal with an exponent other than 0 is `pwr`.
int function_of(const JuliaFractal&);

/// Returns F(q), or q where F has no value.
Vec4 formula_image(const JuliaFractal&, const Vec4& q);

/// The point whose orbit decides whether the given point is in the set.
Vec3 formula_place(const JuliaFractal&, const Vec3&);

/// Gradient of the magnitude at the end of the orbit of formula_place(); once that has escaped, of
/// the point's own orbit.
Vec3 formula_slope(const JuliaSet&, const Vec3&);

}  // namespace candelabra
