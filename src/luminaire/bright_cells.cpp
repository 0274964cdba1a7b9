// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/bright_cells.h"

#include "base/running_sums.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

/// Sample points of each cell, in each direction.
constexpr std::size_t asked = 2;
/// Weight of its neighbours in a cell's brightness: bright spots may reach into cells whose sample
/// points miss them.
constexpr double neighbours = 0.3;

using Sums = std::span<const double>;

/// Prefix sums within a row of cells.
Sums columns_of(const std::vector<double>& all, std::size_t row, std::size_t count) {
    return Sums(all).subspan(row * count, count);
}

std::size_t cell_at(double along, std::size_t count) {
    const auto cell = static_cast<std::size_t>(along * static_cast<double>(count));
    return std::min(cell, count - 1);
}

double along(const DrawnShare& drawn, std::size_t count) {
    return (static_cast<double>(drawn.index) + drawn.within) / static_cast<double>(count);
}

}  // namespace

BrightCells::BrightCells(std::size_t row_count, std::size_t column_count,
                         FunctionRef<std::optional<double>(const Vec2&)> luminance)
    : row_count_(row_count), column_count_(column_count) {
    std::vector<double> seen(row_count * column_count, 0);
    const auto part = [](std::size_t cell, std::size_t n, std::size_t count) {
        return (static_cast<double>(cell) + (static_cast<double>(n) + 0.5) / asked) /
               static_cast<double>(count);
    };
    for (std::size_t i = 0; i < seen.size(); ++i)
        for (std::size_t n = 0; n < asked * asked; ++n) {
            const auto here = luminance({part(i / column_count, n / asked, row_count),
                                         part(i % column_count, n % asked, column_count)});
            if (!here) continue;
            covered_ += 1;
            seen[i] += std::fmax(*here, 0);
            mean_square_ += *here * *here;
        }
    const auto at = [&](std::size_t row, std::size_t column) {
        return seen[std::min(row, row_count - 1) * column_count +
                    std::min(column, column_count - 1)];
    };
    double sum = 0;
    for (std::size_t row = 0; row < row_count; ++row) {
        double of_row = 0;
        for (std::size_t column = 0; column < column_count; ++column) {
            const double beside =
                at(row + 1, column) + at(row - std::min<std::size_t>(row, 1), column) +
                at(row, column + 1) + at(row, column - std::min<std::size_t>(column, 1));
            of_row += (1 - neighbours) * at(row, column) + neighbours / 4 * beside;
            columns_.push_back(of_row);
            mean_ += at(row, column);
        }
        sum += of_row;
        rows_.push_back(sum);
    }
    const double points = static_cast<double>(seen.size() * asked * asked);
    covered_ /= points;
    mean_ /= points;
    mean_square_ /= points;
}

BrightCells::Drawn BrightCells::draw(const Vec2& u) const {
    const DrawnShare row = drawn_share(Sums(rows_), u.x);
    const DrawnShare column = drawn_share(columns_of(columns_, row.index, column_count_), u.y);
    return {{along(row, row_count_), along(column, column_count_)}, share(row.index, column.index)};
}

double BrightCells::density(const Vec2& at) const {
    return share(cell_at(std::clamp(at.x, 0.0, 1.0), row_count_),
                 cell_at(std::clamp(at.y, 0.0, 1.0), column_count_));
}

/// Probability of a cell relative to that under a uniform choice.
double BrightCells::share(std::size_t row, std::size_t column) const {
    const Sums columns = columns_of(columns_, row, column_count_);
    if (!(columns.back() > 0)) return 0;
    return share_of(Sums(rows_), row) * share_of(columns, column) *
           static_cast<double>(row_count_ * column_count_);
}

}  // namespace candelabra
