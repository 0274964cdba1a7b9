// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/plane_blur.h"

#include "base/parallel.h"

#include <algorithm>
#include <cstddef>

namespace candelabra {

namespace {

/// Values in a row or a column.
struct PlaneLine {
    float* first;
    std::size_t count, step;

    float& operator[](std::size_t i) const { return first[i * step]; }
};

/// Replaces each value by the sum from `radius` before it to `radius` behind it. `sums` is a
/// buffer.
void sum_along(const PlaneLine& line, std::size_t radius, std::vector<double>& sums) {
    sums.assign(line.count + 1, 0);
    for (std::size_t i = 0; i < line.count; ++i)
        sums[i + 1] = sums[i] + static_cast<double>(line[i]);
    for (std::size_t i = 0; i < line.count; ++i)
        line[i] = static_cast<float>(sums[std::min(i + radius + 1, line.count)] -
                                     sums[i - std::min(i, radius)]);
}

}  // namespace

void blur(std::vector<float>& plane, int width, int height, int radius, int threads) {
    const auto columns = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height),
               around = static_cast<std::size_t>(radius);
    const auto along = [&](std::size_t lines, const auto& line_of) {
        run_parallel(lines, threads, [&](std::size_t i) {
            std::vector<double> sums;
            const PlaneLine line = line_of(i);
            for (int pass = 0; pass < 2; ++pass) sum_along(line, around, sums);
        });
    };
    along(rows, [&](std::size_t y) { return PlaneLine{plane.data() + y * columns, columns, 1}; });
    along(columns, [&](std::size_t x) { return PlaneLine{plane.data() + x, rows, columns}; });
}

}  // namespace candelabra
