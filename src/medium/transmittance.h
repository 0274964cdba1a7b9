// SPDX-License-Identifier: GPL-3.0-or-later
// The share of light that media leave along a part of a ray: exact where their densities are the
// same everywhere, else an unbiased estimate.
#pragma once

#include "base/random.h"
#include "base/ray.h"
#include "medium/media.h"

namespace candelabra {

/// A part of a ray between two points at which the extinction is known. The ray's direction is a
/// unit vector.
struct MediaSegment {
    const Ray& ray;
    double from, to;
    Vec3 extinction_from, extinction_to;  ///< per unit of length
};

/// No extinction of the media together is greater in any channel, unless a density is below 0.
double max_extinction(MediaView);

/// Whether all of them have the same density everywhere.
bool homogeneous(MediaView);

/// An unbiased estimate of exp(-optical depth) along the segment, per channel: the power series
/// around the trapezoid's value, whose factors are independent estimates of the optical depth, cut
/// off by Russian roulette (Bhanot and Kennedy; for transmittance Kettunen, d'Eon, Pantaleoni and
/// Novak, "An Unbiased Ray-Marching Transmittance Estimator", 2021, whose pivots and weights
/// differ), or ratio tracking where the way may be very deep. It has no variance where the
/// extinction is constant. A way of thousands of greatest mean free paths, as the air has to its
/// end, is known by its ends alone. `greatest` is max_extinction().
Vec3 segment_transmittance(MediaView, const MediaSegment&, double greatest, const PatternScene&,
                           RandomStream&);

/// Russian roulette, where hardly anything is left: false with what is left made up for otherwise.
bool survives(Vec3& left, RandomStream&);

/// The same between two points of a ray, however far apart they are.
Vec3 transmittance(MediaView, const Ray&, const Interval&, const PatternScene&, const Key&);

}  // namespace candelabra
