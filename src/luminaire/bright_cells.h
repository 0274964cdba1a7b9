// SPDX-License-Identifier: GPL-3.0-or-later
// How bright a surface is in the cells of a raster, and points of the raster that are drawn in
// proportion. The map of a luminaire's brightness has one for each of its faces.
#pragma once

#include "base/function_ref.h"
#include "base/vector.h"

#include <optional>
#include <vector>

namespace candelabra {

class BrightCells {
public:
    /// `luminance` is asked at four points of each cell of the unit square; it has none where there
    /// is no surface.
    BrightCells(std::size_t rows, std::size_t columns,
                FunctionRef<std::optional<double>(const Vec2&)> luminance);

    /// Share of the square where there is a surface.
    double covered() const { return covered_; }
    /// Of the luminance and of its square over the whole square, 0 where there is no surface.
    double mean() const { return mean_; }
    double mean_square() const { return mean_square_; }

    struct Drawn {
        Vec2 at;
        double density;  ///< 1 where all are as bright
    };
    /// Precondition: mean() > 0.
    Drawn draw(const Vec2& u) const;
    /// The density with which draw() gives a point of the square.
    double density(const Vec2& at) const;

private:
    double share(std::size_t row, std::size_t column) const;

    std::size_t row_count_, column_count_;
    double covered_ = 0, mean_ = 0, mean_square_ = 0;
    /// Sums of brightness: up to each row, and within each.
    std::vector<double> rows_ = {}, columns_ = {};
};

}  // namespace candelabra
