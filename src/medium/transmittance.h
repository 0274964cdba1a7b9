// SPDX-License-Identifier: GPL-3.0-or-later
// Transmittance of media along a part of a ray: exact if their densities are constant, else an
// unbiased estimate.
#pragma once

#include "base/random.h"
#include "base/ray.h"
#include "base/rgb.h"
#include "medium/media.h"

namespace candelabra {

/// A segment of a ray with the extinction at both ends. The ray's direction is a unit vector.
struct MediaSegment {
    const Ray& ray;
    double from, to;
    Rgb extinction_from, extinction_to;  ///< per unit of length
};

/// Upper bound of the extinction of all media together, over all channels, unless a density is
/// below 0.
double max_extinction(MediaView);

/// Whether all densities are constant.
bool homogeneous(MediaView);

/// Returns an unbiased estimate of exp(-optical depth) along the segment, per channel. It is the
/// power series around the trapezoid's value, whose factors are independent estimates of the
/// optical depth, terminated by Russian roulette (Bhanot and Kennedy; for transmittance Kettunen,
/// d'Eon, Pantaleoni and Novak, "An Unbiased Ray-Marching Transmittance Estimator", 2021, whose
/// pivots and weights differ). Where the segment may be very deep, ratio tracking is used instead.
/// The variance is 0 if the extinction is constant. A segment of thousands of minimum mean free
/// paths, such as one to the end of the air, is evaluated at its ends alone. `greatest` is
/// max_extinction().
Rgb segment_transmittance(MediaView, const MediaSegment&, double greatest, const PatternScene&,
                          RandomStream&);

/// Russian roulette at low transmittance: returns whether `left` survives, and rescales it if so.
bool survives(Rgb& left, RandomStream&);

/// The same between two points of a ray at any distance from each other.
Rgb transmittance(MediaView, const Ray&, const Interval&, const PatternScene&, const Key&);

}  // namespace candelabra
