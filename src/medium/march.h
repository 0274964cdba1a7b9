// SPDX-License-Identifier: GPL-3.0-or-later
// Ray marching through media: returns their transmittance, their emission, and points at which to
// evaluate the light that they scatter towards the viewer.
#pragma once

#include "base/function_ref.h"
#include "base/random.h"
#include "base/ray.h"
#include "base/rgb.h"
#include "base/short_list.h"
#include "medium/media.h"
#include "medium/veil.h"

#include <cstddef>

namespace candelabra {

/// A point of a ray where media scatter light towards the viewer.
struct MediaPlace {
    double distance = 0;
    /// Weight of the radiance scattered there per unit of length: the transmittance between viewer
    /// and point, times the length that the point represents.
    Rgb weight = Rgb(0);
    Rgb scattering = Rgb(0);  ///< coefficient, without phase functions
};

struct MediaMarch {
    Veil veil;                     ///< adds the emission
    Rgb of_luminaires = Rgb(0);    ///< the part of the emission that belongs to luminaires
    /// Empty if nothing is scattered. The sum over the places of weight times a function of the
    /// distance is an unbiased estimate of the integral of that function times the transmittance.
    ShortList<MediaPlace, 64> places;
};

/// A part of a ray, starting at its origin, and how it is marched.
struct MediaStretch {
    const Ray& ray;  ///< its direction is a unit vector
    double distance;
    double near = 0;  ///< extent of most of the scene: points beyond are sparse; 0: no limit
    int count = 8;    ///< approximate number of points
    /// Fills the second span with the importance of the positions in the first one, on any scale,
    /// not below 0. Points are denser where the importance is higher, and never absent where it is
    /// 0. Null: constant importance.
    using Worth = FunctionRef<void(std::span<const Vec3>, std::span<double>)>;
    const Worth* worth = nullptr;
    bool counted = false;  ///< luminaires' emission is counted elsewhere
    /// Whether the emission of the medium with that index shows at a point; null: everywhere.
    using Shows = FunctionRef<bool(std::size_t, const Vec3&)>;
    const Shows* shows = nullptr;
    LightInAir light = LightInAir::any;  ///< what may be scattered
};

void march(MediaView, const MediaStretch&, const PatternScene&, const Key&, MediaMarch&);

}  // namespace candelabra
