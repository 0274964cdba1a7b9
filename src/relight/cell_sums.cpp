// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/cell_sums.h"

#include "base/parallel.h"

#include <algorithm>

namespace candelabra {

namespace {

/// Cells in a row or a column of the picture.
struct CellLine {
    double* first;
    std::size_t count, step, numbers;
};

/// Replaces each value by the sum from `radius` before it to `radius` behind it, where a cell at
/// either end may count in part. `sums` is a buffer.
void sum_along(const CellLine& line, double radius, std::vector<double>& sums) {
    const std::size_t numbers = line.numbers, count = line.count;
    const auto whole = static_cast<std::size_t>(radius);
    const double part = radius - static_cast<double>(whole);
    // The sums of all cells before each one.
    sums.assign((count + 1) * numbers, 0);
    for (std::size_t i = 0; i < count; ++i) {
        const double* const from = line.first + i * line.step;
        const double* const before = sums.data() + i * numbers;
        double* const next = sums.data() + (i + 1) * numbers;
        for (std::size_t k = 0; k < numbers; ++k) next[k] = before[k] + from[k];
    }
    for (std::size_t i = 0; i < count; ++i) {
        const auto sum_before = [&](std::size_t end) {
            return sums.data() + std::min(end, count) * numbers;
        };
        const std::size_t begin = i - std::min(i, whole), wide = i - std::min(i, whole + 1);
        const double *const last = sum_before(i + whole + 1), *const first = sum_before(begin),
                            *const beyond = sum_before(i + whole + 2),
                            *const below = sum_before(wide);
        double* const to = line.first + i * line.step;
        for (std::size_t k = 0; k < numbers; ++k)
            to[k] = (1 - part) * (last[k] - first[k]) + part * (beyond[k] - below[k]);
    }
}

}  // namespace

void blur(CellSums& cells, double radius, int threads) {
    const auto along = [&](std::size_t lines, const auto& line_of) {
        run_parallel(lines, threads, [&](std::size_t i) {
            std::vector<double> sums;
            const CellLine line = line_of(i);
            for (int pass = 0; pass < 2; ++pass) sum_along(line, radius, sums);
        });
    };
    along(cells.rows, [&](std::size_t y) {
        return CellLine{cells.at(0, y), cells.columns, cells.numbers, cells.numbers};
    });
    along(cells.columns, [&](std::size_t x) {
        return CellLine{cells.at(x, 0), cells.rows, cells.columns * cells.numbers, cells.numbers};
    });
}

}  // namespace candelabra
