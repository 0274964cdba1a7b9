// SPDX-License-Identifier: GPL-3.0-or-later
// A part of space that glows: flames, gas in tubes, nebulae. Called through luminaire.h, which
// states what each function promises. Its "points" lie between surfaces, so no ray meets one: the
// density of a point is that of its direction times the one of its distance along it, and what
// counts there is the radiance that is emitted along a unit of length.
#pragma once

#include "luminaire/luminaire.h"

#include <array>

namespace candelabra {

/// How bright the emission is in the cells of a box, as far as it was looked at.
class EmissionGrid {
public:
    static constexpr std::size_t side = 4, count = side * side * side;

    /// Mean luminance that is emitted in each cell along a unit of length, not below 0; x goes
    /// first. `least`: what the mean of all counts as at least, above 0: something may have been
    /// missed.
    EmissionGrid(const std::array<double, count>& brightness, double least);

    double mean() const { return mean_; }
    double brightness(std::size_t cell) const { return brightness_[cell]; }
    /// The chance that a cell is drawn; never 0.
    double chance(std::size_t cell) const;
    /// The cell for u, which is uniform in [0, 1); what is left of u goes back, likewise.
    std::size_t draw(double& u) const;

private:
    std::array<double, count> brightness_;
    std::array<double, count> until_;  ///< sums of the chances
    double mean_;
};

LightBounds bounds(const VolumeEmitter&, double luminance);
double unoccluded(const VolumeEmitter&, double luminance, const Receiver&);
/// By the cells, and from nearby also by direction, which keeps the estimate within bounds.
std::optional<LightPoint> sample(const VolumeEmitter&, const Vec3& from, const Vec2& u);
void intersect(const VolumeEmitter&, const Receiver&, const Vec3& direction, LightHits&);
std::optional<EmittedRay> emit(const VolumeEmitter&, const Vec2& where, const Vec2& direction);
/// Mean luminance of what is emitted about a point of the box, along a unit of length.
double emitted_about(const VolumeEmitter&, const Vec3& point);
/// Of a surface that has its greatest radiance all over, and gives about as much light.
double emitting_area(const VolumeEmitter&);

}  // namespace candelabra
