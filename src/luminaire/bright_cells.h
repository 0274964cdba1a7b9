// SPDX-License-Identifier: GPL-3.0-or-later
// Brightness of a surface over the cells of a raster, and points of the raster drawn in proportion
// to it. A Brightness map has one raster for each face of its luminaire.
#pragma once

#include "base/function_ref.h"
#include "base/vector.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace candelabra {

class BrightCells {
public:
    /// `luminance` is evaluated at four points of each cell of the unit square; it returns nothing
    /// where there is no surface.
    BrightCells(std::size_t rows, std::size_t columns,
                FunctionRef<std::optional<double>(const Vec2&)> luminance);

    /// Fraction of the square that the surface covers.
    double covered() const { return covered_; }
    /// Mean of the luminance, and of its square, over the whole square; 0 where there is no
    /// surface.
    double mean() const { return mean_; }
    double mean_square() const { return mean_square_; }

    struct Drawn {
        Vec2 at;
        double density;  ///< relative to a uniform density, which is 1
    };
    /// Precondition: mean() > 0.
    Drawn draw(const Vec2& u) const;
    /// Density with which draw() returns this point of the square.
    double density(const Vec2& at) const;

private:
    double share(std::size_t row, std::size_t column) const;

    std::size_t row_count_, column_count_;
    double covered_ = 0, mean_ = 0, mean_square_ = 0;
    /// Prefix sums of the brightness: over the rows, and over the cells of each row.
    std::vector<double> rows_ = {}, columns_ = {};
};

}  // namespace candelabra
