// SPDX-License-Identifier: GPL-3.0-or-later
// The orbit of a point under q -> F(q) + c, which defines a Julia fractal. The rules are those that
// POV-Ray 3.7 computes, including its errors.
#pragma once

#include "shape/julia_fractal.h"

#include <array>

namespace candelabra {

struct JuliaOrbit {
    bool stays = false;    ///< the orbit stays within the escape radius for max_iteration steps
    double distance2 = 0;  ///< squared distance of the last point from 0
    double step = 0;       ///< lower bound of the distance to the set; 0 where unknown
};

/// A Julia fractal, with the data that all of its orbits share.
struct JuliaSet {
    JuliaSet(const JuliaFractal& fractal);

    /// Maps a point of space to a number.
    Vec4 place(const Vec3&) const;

    const JuliaFractal& julia;
    bool by_formula;  ///< its function is a formula of complex numbers
    Vec4 slice;       ///< unit normal
    double limit2;    ///< squared escape radius: no orbit returns from beyond
};

JuliaOrbit julia_orbit(const JuliaSet&, const Vec3&);

/// Whether the point is in the set; for functions by formula its own orbit does not decide this.
bool julia_contains(const JuliaSet&, const Vec3&);

/// Number of leading points, of four on a ray, that are known to stay in the set. A quick look
/// ahead, which may return fewer than there are.
int julia_stays(const JuliaSet&, const Ray&, const std::array<double, 4>& places);

/// Squared distance from 0 after all steps, continued past the escape; normals are its gradient.
double julia_size(const JuliaSet&, const Vec3&);

/// Radius of a sphere around 0 that contains the set.
double julia_radius(const JuliaFractal&);

}  // namespace candelabra
