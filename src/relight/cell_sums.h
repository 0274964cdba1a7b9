// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over the cells of a picture, and their blur.
#pragma once

#include <cstddef>
#include <vector>

namespace candelabra {

/// Some numbers for each cell, row by row.
struct CellSums {
    std::size_t columns = 0, rows = 0, numbers = 0;
    std::vector<double> values;

    CellSums() = default;
    CellSums(std::size_t columns_of_cells, std::size_t rows_of_cells, std::size_t numbers_of_cell)
        : columns(columns_of_cells),
          rows(rows_of_cells),
          numbers(numbers_of_cell),
          values(columns * rows * numbers) {}

    double* at(std::size_t column, std::size_t row) {
        return values.data() + (row * columns + column) * numbers;
    }
    const double* at(std::size_t column, std::size_t row) const {
        return values.data() + (row * columns + column) * numbers;
    }
};

/// Replaces each value by a sum over its surroundings, with weights that fall linearly to 0 at
/// about twice the radius, along rows and columns. The radius is in cells, and may be a fraction.
/// Outside of the picture there is nothing. The time does not depend on the radius.
void blur(CellSums&, double radius, int threads);

}  // namespace candelabra
