// SPDX-License-Identifier: GPL-3.0-or-later
// Ratings of glare: for people indoors (CIE 117, the unified glare rating) and for drivers (EN
// 13201-3, the threshold increment).
#pragma once

#include "base/vector.h"

namespace candelabra {

/// An observer's line of sight and vertical.
struct Sightline {
    Vec3 ahead;  ///< unit
    Vec3 up;     ///< unit, not along the line of sight
};

/// Guth's position index of a direction, a unit vector: how much less glare counts there than on
/// the line of sight. Above it by the formula that fits the table of CIE 117 within 3 %, below it
/// by that of Iwata and Tokura. At most 16; 0 behind the observer, where nothing counts.
double guth_index(const Sightline&, const Vec3& direction);

/// The rating of CIE 117. `background`: luminance in cd/m2 of the indirect light, above 0.
/// `sources`: sum over all luminaires of the square of luminance, times solid angle, over the
/// square of Guth's index. It is 0 if there is no glare at all.
double unified_glare_rating(double background, double sources);

/// Factor by which illuminance at an eye, on the plane across the line of sight, counts in the
/// veiling luminance of EN 13201-3 (for an age of 23 years) if it comes from a direction: 0 within
/// 1.5 degrees of the line of sight, beyond 60 degrees, and where the roof of a car hides it, 20
/// degrees above the horizon.
double veil_factor(const Sightline&, const Vec3& direction);

/// The threshold increment in per cent of a veiling luminance on a road of that mean luminance, in
/// cd/m2.
double threshold_increment(double veil, double road);

}  // namespace candelabra
