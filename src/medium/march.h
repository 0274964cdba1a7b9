// SPDX-License-Identifier: GPL-3.0-or-later
// A walk along a part of a ray through media: what they leave of the light behind them, what they
// emit, and points at which they may be asked for light that they scatter to the viewer.
#pragma once

#include "base/function_ref.h"
#include "base/random.h"
#include "base/ray.h"
#include "base/short_list.h"
#include "medium/media.h"
#include "medium/veil.h"

namespace candelabra {

/// A point of a ray where media scatter light to the viewer.
struct MediaPlace {
    double distance = 0;
    /// By what the radiance that is scattered there, per unit of length, counts for the viewer:
    /// the transmittance from there, times the length that the point stands for.
    Vec3 weight = Vec3(0);
    Vec3 scattering = Vec3(0);  ///< coefficient, without phase functions
};

struct MediaMarch {
    Veil veil;                     ///< emission is what it adds
    Vec3 of_luminaires = Vec3(0);  ///< the part of it that is luminaires'
    /// Empty where nothing is scattered. The sum of weight times a function of the distance over
    /// them is an unbiased estimate of that function's integral times the transmittance.
    ShortList<MediaPlace, 64> places;
};

/// A part of a ray, from its origin on, and how it is walked.
struct MediaStretch {
    const Ray& ray;  ///< its direction is a unit vector
    double distance;
    double near = 0;  ///< how far most of the scene lies: beyond, points are rare; 0: all is near
    int count = 8;    ///< about the number of points
    /// Fills the second span with what points at the places of the first are worth, on any scale,
    /// not below 0: points are denser where they are worth more. Null: all are worth the same. What
    /// is 0 does not stay without points.
    using Worth = FunctionRef<void(std::span<const Vec3>, std::span<double>)>;
    const Worth* worth = nullptr;
    bool counted = false;  ///< what luminaires emit does not count here
};

void march(MediaView, const MediaStretch&, const PatternScene&, const Key&, MediaMarch&);

}  // namespace candelabra
