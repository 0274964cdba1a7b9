// SPDX-License-Identifier: GPL-3.0-or-later
#include "backdrop/sky_light.h"

#include "base/circle.h"
#include "base/elementary.h"
#include "base/running_sums.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace candelabra {

namespace {

using std::numbers::pi;

// Cells have equal extents in height (the cosine of the angle from the top), so equal solid angles.
constexpr int row_count = 256, column_count = 512;
constexpr double cell_angle = 4 * pi / (row_count * column_count);

/// Fraction of the directions that are drawn uniformly.
constexpr double even_share = 0.1;

double brightness(const Rgb& seen) {
    const double sum = std::max(seen.r, 0.0) + std::max(seen.g, 0.0) + std::max(seen.b, 0.0);
    return std::isfinite(sum) ? sum : 0;
}

using Sums = std::span<const float>;

/// Prefix sums within a row of cells.
Sums columns_of(const std::vector<float>& all, std::size_t row) {
    return Sums(all).subspan(row * column_count, column_count);
}

/// Position in a row or a column from the left or the top, in [0, 1].
double along(const DrawnShare& drawn, int count) {
    return (static_cast<double>(drawn.index) + drawn.within) / count;
}

}  // namespace

SkyLight::SkyLight(FunctionRef<Rgb(const Vec3& direction)> radiance) {
    rows_.reserve(row_count);
    columns_.reserve(static_cast<std::size_t>(row_count) * column_count);
    double all = 0;
    for (int row = 0; row < row_count; ++row) {
        const double height = 1 - (row + 0.5) * 2 / row_count;
        double sum = 0;
        for (int column = 0; column < column_count; ++column) {
            for (const double offset : {0.25, 0.75})
                sum += brightness(radiance(at_height(height + (0.5 - offset) * 2 / row_count,
                                                     (column + offset) / column_count)));
            columns_.push_back(static_cast<float>(sum));
        }
        all += sum;
        rows_.push_back(static_cast<float>(all));
    }
    if (all > 0) return;
    for (int i = 0; i < row_count; ++i)
        rows_[static_cast<std::size_t>(i)] = static_cast<float>(i + 1);
}

SkyLight::Drawn SkyLight::draw(Vec2 place) const {
    double v = place.y;
    Vec3 direction;
    if (v < even_share) {
        direction = at_height(1 - 2 * v / even_share, place.x);
    } else {
        v = (v - even_share) / (1 - even_share);
        const DrawnShare row = drawn_share(Sums(rows_), v);
        const Sums columns = columns_of(columns_, row.index);
        const double height = 1 - 2 * along(row, row_count);
        direction = at_height(height, columns.back() > 0
                                          ? along(drawn_share(columns, place.x), column_count)
                                          : place.x);
    }
    return {direction, density(direction)};
}

double SkyLight::density(const Vec3& direction) const {
    constexpr double even = even_share / (4 * pi);
    const double height = std::clamp(direction.y, -1.0, 1.0);
    const int row = std::clamp(static_cast<int>((1 - height) / 2 * row_count), 0, row_count - 1);
    double turn = math::atan2(direction.z, direction.x) / (2 * pi);
    turn -= std::floor(turn);
    const int column = std::clamp(static_cast<int>(turn * column_count), 0, column_count - 1);
    const Sums columns = columns_of(columns_, static_cast<std::size_t>(row));
    const double of_row = share_of(Sums(rows_), static_cast<std::size_t>(row));
    const double of_column = columns.back() > 0
                                 ? share_of(columns, static_cast<std::size_t>(column))
                                 : 1.0 / column_count;
    return even + (1 - even_share) * of_row * of_column / cell_angle;
}

}  // namespace candelabra
