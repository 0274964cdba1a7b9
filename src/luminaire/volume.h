// SPDX-License-Identifier: GPL-3.0-or-later
// An emitting volume: flames, gas in tubes, nebulae. Called through luminaire.h, which documents
// each function. Its sample points lie between surfaces, so no ray meets one. The density of a
// point is that of its direction times that of its distance along the ray, and its contribution is
// the radiance emitted per unit of length.
#pragma once

#include "luminaire/luminaire.h"

#include <array>

namespace candelabra {

/// Brightness of the emission in the cells of a box, as far as it was sampled.
class EmissionGrid {
public:
    static constexpr std::size_t side = 4, count = side * side * side;

    /// `brightness` is the mean luminance emitted per unit of length in each cell, not below 0; x
    /// varies fastest. `least`, above 0, is the minimum of mean(), since the samples may have
    /// missed emission.
    EmissionGrid(const std::array<double, count>& brightness, double least);

    double mean() const { return mean_; }
    double brightness(std::size_t cell) const { return brightness_[cell]; }
    /// Probability of drawing a cell; never 0.
    double chance(std::size_t cell) const;
    /// Returns the cell for u, uniform in [0, 1), and rescales u so that it is uniform again.
    std::size_t draw(double& u) const;

private:
    std::array<double, count> brightness_;
    std::array<double, count> until_;  ///< prefix sums of the probabilities
    double mean_;
};

LightBounds bounds(const VolumeEmitter&, double luminance);
double unoccluded(const VolumeEmitter&, double luminance, const Receiver&);
/// Samples by cell, and nearby also by direction, which keeps the estimate bounded.
std::optional<LightPoint> sample(const VolumeEmitter&, const Vec3& from, const Vec2& u);
void intersect(const VolumeEmitter&, const Receiver&, const Vec3& direction, LightHits&);
std::optional<EmittedRay> emit(const VolumeEmitter&, double inner, const EmissionDraw&);
/// Mean luminance emitted per unit of length around a point of the box.
double emitted_about(const VolumeEmitter&, const Vec3& point);
/// Area of a surface that emits about as much light if it has the maximum radiance everywhere.
double emitting_area(const VolumeEmitter&);

}  // namespace candelabra
