// SPDX-License-Identifier: GPL-3.0-or-later
#include "backdrop/sky_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace {

using std::numbers::pi;

// Cells have equal heights (the cosine of the angle from the top), so equal solid angles.
constexpr int row_count = 256, column_count = 512;
constexpr double cell_angle = 4 * pi / (row_count * column_count);

/// The share of directions that are drawn evenly, whatever the map says.
constexpr double even_share = 0.1;

Vec3 direction_at(double height, double turn) {
    const double across = std::sqrt(std::max(0.0, 1 - height * height));
    return {across * std::cos(2 * pi * turn), height, across * std::sin(2 * pi * turn)};
}

/// Index of the first sum above u, and where u lies between it and the one before.
struct Found {
    int index;
    double within;
    double share;
};
Found search(std::span<const float> sums, double u) {
    const double at = u * static_cast<double>(sums.back());
    auto above = std::ranges::upper_bound(sums, static_cast<float>(at));
    if (above == sums.end()) --above;
    const auto index = static_cast<int>(above - sums.begin());
    const double before =
        index > 0 ? static_cast<double>(sums[static_cast<std::size_t>(index - 1)]) : 0.0;
    const double share = static_cast<double>(*above) - before;
    const double within = share > 0 ? (at - before) / share : 0.5;
    return {index, std::clamp(within, 0.0, 1 - 0x1p-53), share};
}

double brightness(const Vec3& seen) {
    const double sum = std::max(seen.x, 0.0) + std::max(seen.y, 0.0) + std::max(seen.z, 0.0);
    return std::isfinite(sum) ? sum : 0;
}

double share_at(std::span<const float> sums, int index) {
    const auto i = static_cast<std::size_t>(index);
    return static_cast<double>(sums[i]) - (i > 0 ? static_cast<double>(sums[i - 1]) : 0.0);
}

}  // namespace

SkyLight::SkyLight(FunctionRef<Vec3(const Vec3& direction)> radiance) {
    rows_.reserve(row_count);
    columns_.reserve(static_cast<std::size_t>(row_count) * column_count);
    double all = 0;
    for (int row = 0; row < row_count; ++row) {
        const double height = 1 - (row + 0.5) * 2 / row_count;
        double sum = 0;
        for (int column = 0; column < column_count; ++column) {
            for (const double offset : {0.25, 0.75})
                sum += brightness(radiance(direction_at(height + (0.5 - offset) * 2 / row_count,
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
        direction = direction_at(1 - 2 * v / even_share, place.x);
    } else {
        v = (v - even_share) / (1 - even_share);
        const Found row = search(rows_, v);
        const auto columns = std::span(columns_).subspan(
            static_cast<std::size_t>(row.index) * column_count, column_count);
        if (!(columns.back() > 0)) {
            direction = direction_at(1 - (row.index + row.within) * 2 / row_count, place.x);
        } else {
            const Found column = search(columns, place.x);
            direction = direction_at(1 - (row.index + row.within) * 2 / row_count,
                                     (column.index + column.within) / column_count);
        }
    }
    return {direction, density(direction)};
}

double SkyLight::density(const Vec3& direction) const {
    constexpr double even = even_share / (4 * pi);
    const double height = std::clamp(direction.y, -1.0, 1.0);
    const int row = std::clamp(static_cast<int>((1 - height) / 2 * row_count), 0, row_count - 1);
    double turn = std::atan2(direction.z, direction.x) / (2 * pi);
    turn -= std::floor(turn);
    const int column = std::clamp(static_cast<int>(turn * column_count), 0, column_count - 1);
    const auto columns =
        std::span(columns_).subspan(static_cast<std::size_t>(row) * column_count, column_count);
    const double of_row = share_at(rows_, row) / static_cast<double>(rows_.back());
    const double of_column = columns.back() > 0
                                 ? share_at(columns, column) / static_cast<double>(columns.back())
                                 : 1.0 / column_count;
    return even + (1 - even_share) * of_row * of_column / cell_angle;
}
