// SPDX-License-Identifier: GPL-3.0-or-later
// A box of media that light the scene: flames, gas in tubes, nebulae. It is no luminaire: its
// points lie between surfaces, so no ray meets one. The density of a point is that of its direction
// times that of its distance along the ray, and its contribution is the radiance emitted per unit
// of length.
#pragma once

#include "luminaire/luminaire.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

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

/// A box, or part of one, filled with a medium that lights the scene.
struct MediaBox {
    Box box;
    Handle<EmissionGrid> grid;
    Rgb radiance;             ///< maximum emitted along a line through it, per channel
    std::uint32_t primitive;  ///< index in the world of one primitive of the enclosing solid
};

LightBounds bounds(const MediaBox&);
/// Estimates the unoccluded irradiance at the point, as luminance.
double unoccluded(const MediaBox&, const Receiver&);
/// Returns a point that may be visible, u is in [0, 1)^2; nothing if the drawn one cannot be.
/// Samples by cell, and nearby also by direction, which keeps the estimate bounded.
std::optional<LightPoint> sample(const MediaBox&, const Vec3& from, const Vec2& u);
inline std::optional<LightPoint> sample(const MediaBox& box, const Receiver& point, const Vec2& u) {
    return sample(box, point.position, u);
}
/// Returns a ray that starts in the box, in any direction: see emit() in luminaire.h.
EmittedRay emit(const MediaBox&, const EmissionDraw&);
/// Mean luminance emitted per unit of length around a point of the box.
double emitted_about(const MediaBox&, const Vec3& point);
/// Area of a surface that emits about as much light if it has the maximum radiance everywhere.
double area_of_equal_light(const MediaBox&);

}  // namespace candelabra
