// SPDX-License-Identifier: GPL-3.0-or-later
// The orbit of a point under q -> F(q) + c: what a Julia fractal is made of. The rules are those
// that POV-Ray 3.7 computes, with its mistakes.
#pragma once

#include "shape/julia_fractal.h"

#include <array>

namespace candelabra {

struct JuliaOrbit {
    bool stays = false;    ///< within max_iteration steps the orbit does not get far
    double distance2 = 0;  ///< from 0, of the last point
    double step = 0;       ///< how far the set is at least, where that is known (0 where it is not)
};

/// A Julia fractal with what all of its orbits have in common.
struct JuliaSet {
    JuliaSet(const JuliaFractal& fractal);

    /// A point of space as a number.
    Vec4 place(const Vec3&) const;

    const JuliaFractal& julia;
    bool by_formula;  ///< of complex numbers
    Vec4 slice;       ///< unit normal
    double limit2;    ///< the square of a distance from which no orbit comes back
};

JuliaOrbit julia_orbit(const JuliaSet&, const Vec3&);

/// Whether the point counts as in the set: for functions by formula not what its orbit says.
bool julia_contains(const JuliaSet&, const Vec3&);

/// How many of the first of four points of a ray are known to stay in the set: a quick look ahead,
/// which need not see any.
int julia_stays(const JuliaSet&, const Ray&, const std::array<double, 4>& places);

/// The square of the distance from 0 after all steps, also behind the escape: what normals are the
/// slope of.
double julia_size(const JuliaSet&, const Vec3&);

/// No point outside of the sphere with this radius is in the set.
double julia_radius(const JuliaFractal&);

}  // namespace candelabra
