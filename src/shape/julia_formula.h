// SPDX-License-Identifier: GPL-3.0-or-later
// Julia fractals of hypercomplex numbers whose function is a formula of complex ones: `sin`, `exp`,
// `pwr` and so on. POV-Ray 3.7 makes two mistakes with them, which everybody's pictures show. A
// point counts as in the set when the orbit of another one stays, at which y stands for z, too; but
// rays look for the set with the orbits of the points themselves. And of the function's
// derivatives, by which the slope is found, the first is taken for the point, and the others for
// the values; of 1 / q only the first.
#pragma once

#include "shape/julia_orbit.h"

namespace candelabra {

/// `pwr` is known by its exponent.
int function_of(const JuliaFractal&);
bool is_by_formula(const JuliaFractal&);

/// F(q); q, where there is no value.
Vec4 formula_image(const JuliaFractal&, const Vec4& q);

/// The point whose orbit says whether this one is in the set.
Vec3 formula_place(const JuliaFractal&, const Vec3&);

/// Up the size at the end of the orbit, which after its escape is that of the point itself.
Vec3 formula_slope(const JuliaSet&, const Vec3&);

}  // namespace candelabra
