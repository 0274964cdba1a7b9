// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/smooth_crowds.h"

#include "base/order.h"
#include "base/parallel.h"
#include "relight/half.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace candelabra {

namespace {

constexpr std::size_t terms = SmoothCrowds::terms;
/// Products of two terms, each pair once.
constexpr std::size_t products = terms * (terms + 1) / 2;
/// How much wider the surroundings are in which samples of single lamps are averaged.
constexpr double wider_for_samples = 5;
/// Variance that is added to that of each term: of normals, and of places in terms of the radius.
constexpr double ridge = 1e-3;

/// Replaces a symmetric matrix by its inverse. Returns false if it is not positive definite.
template <std::size_t Size>
bool invert(std::array<double, Size * Size>& matrix) {
    // By Gauss and Jordan; a positive definite matrix needs no search for a pivot.
    double greatest = 0;
    for (std::size_t i = 0; i < Size; ++i) greatest = std::max(greatest, matrix[i * Size + i]);
    constexpr double rounding = 1e-12;
    for (std::size_t i = 0; i < Size; ++i) {
        const double pivot = matrix[i * Size + i];
        if (!(pivot > rounding * greatest)) return false;
        matrix[i * Size + i] = 1;
        for (std::size_t k = 0; k < Size; ++k) matrix[i * Size + k] /= pivot;
        for (std::size_t j = 0; j < Size; ++j) {
            if (j == i) continue;
            const double factor = std::exchange(matrix[j * Size + i], 0);
            for (std::size_t k = 0; k < Size; ++k)
                matrix[j * Size + k] -= factor * matrix[i * Size + k];
        }
    }
    return true;
}

/// Weights of the points between cells, by which values at their centres are interpolated: a column
/// for each point of a tile, from the cell before the tile to the one behind it.
template <std::size_t Parts>
constexpr auto interpolation() {
    std::array<std::array<float, light_tile>, Parts + 2> weights{};
    constexpr double size = static_cast<double>(light_tile) / Parts;
    for (std::size_t i = 0; i < light_tile; ++i) {
        // In cells, from the centre of the one before the tile.
        const double at = (static_cast<double>(i) + 0.5) / size + 0.5;
        const auto first = static_cast<std::size_t>(at);
        weights[first][i] = static_cast<float>(1 - (at - static_cast<double>(first)));
        weights[first + 1][i] = static_cast<float>(at - static_cast<double>(first));
    }
    return weights;
}

/// The number of a cell or a tile, `before` of which lie before the one asked for, within 0 to
/// count - 1: beyond the edge it is the one at the edge.
std::size_t within(std::size_t place, std::size_t before, std::size_t count) {
    return std::min(place - std::min(place, before), count - 1);
}

}  // namespace

SmoothCrowds::SmoothCrowds(const LightRecords& records, int radius, int threads)
    : records_(records),
      radius_(radius),
      threads_(threads),
      columns_(static_cast<std::size_t>(records.tiles_across())),
      rows_(static_cast<std::size_t>(records.tiles_down())),
      tiles_(records.tiles.size()) {
    CellSums of_cells(along * columns_, along * rows_, 3 * products), of_tiles(columns_, rows_, 3);
    run_parallel(tiles_.size(), threads_, [&](std::size_t number) {
        take(number);
        const TilePlanes& usual = tiles_[number].usual;
        for (std::size_t pixel = 0; pixel < tile_pixels; ++pixel) {
            const auto term = terms_of(number, pixel);
            const std::size_t column = pixel % light_tile / cell, row = pixel / light_tile / cell;
            double* const sums =
                of_cells.at(number % columns_ * along + column, number / columns_ * along + row);
            double* const all = of_tiles.at(number % columns_, number / columns_);
            for (std::size_t c = 0; c < 3; ++c) {
                const auto light = static_cast<double>(usual[c * tile_pixels + pixel]);
                all[c] += light;
                double* at = sums + c * products;
                for (std::size_t i = 0; i < terms; ++i)
                    for (std::size_t j = i; j < terms; ++j)
                        *at++ +=
                            light * static_cast<double>(term[i]) * static_cast<double>(term[j]);
            }
        }
    });
    blur(of_cells, radius_ / cell, threads_);
    blur(of_tiles, wider_for_samples * radius_ / light_tile, threads_);
    prepare(of_cells, of_tiles);
}

std::array<float, terms> SmoothCrowds::terms_of(std::size_t tile, std::size_t pixel) const {
    const TilePlanes& normals = tiles_[tile].normals;
    const auto place = [&](std::size_t number, std::size_t in_tile) {
        return static_cast<float>(static_cast<double>(number * light_tile + in_tile) / radius_);
    };
    return {1,
            normals[pixel],
            normals[tile_pixels + pixel],
            normals[2 * tile_pixels + pixel],
            place(tile % columns_, pixel % light_tile),
            place(tile / columns_, pixel / light_tile)};
}

/// Makes the sums of a tile, of which all frames are made.
void SmoothCrowds::take(std::size_t number) {
    const TileRecords& from = records_.tiles[number];
    Tile& tile = tiles_[number];
    const auto width = static_cast<std::size_t>(records_.width);
    std::vector<std::size_t> inside;
    std::array<std::array<float, terms>, tile_pixels> term{};
    for (std::size_t pixel = 0; pixel < tile_pixels; ++pixel) {
        const std::size_t x = number % columns_ * light_tile + pixel % light_tile,
                          y = number / columns_ * light_tile + pixel / light_tile;
        if (x >= width || y >= static_cast<std::size_t>(records_.height)) continue;
        inside.push_back(pixel);
        constexpr float unit = 127;
        for (std::size_t c = 0; c < 3 && !records_.normals.empty(); ++c)
            tile.normals[c * tile_pixels + pixel] =
                static_cast<float>(records_.normals[3 * (y * width + x) + c]) / unit;
        term[pixel] = terms_of(number, pixel);
    }
    std::vector<std::uint32_t> place(from.nodes.size());
    for (std::size_t n = 0; n < from.nodes.size(); ++n) {
        if (from.nodes[n].size() == 1) continue;
        place[n] = static_cast<std::uint32_t>(tile.nodes.size());
        tile.nodes.push_back(static_cast<std::uint32_t>(n));
        NodeSums& sums = tile.sums.emplace_back();
        for (std::size_t c = 0; c < 3; ++c)
            for (const std::size_t pixel : inside) {
                const float light =
                    from_half(from.light[(3 * n + c) * tile_pixels + pixel]) * from.scale;
                tile.usual[c * tile_pixels + pixel] += light;
                const std::size_t column = pixel % light_tile / cell,
                                  row = pixel / light_tile / cell;
                float* const to = &sums[(c * cells_of_tile + row * along + column) * terms];
                for (std::size_t i = 0; i < terms; ++i) to[i] += light * term[pixel][i];
            }
    }
    for (const LampEntry& entry : from.residual) {
        const auto after = std::ranges::upper_bound(from.nodes, entry.lamp, {}, &LampRange::first);
        const auto node = static_cast<std::size_t>(after - from.nodes.begin()) - 1;
        tile.samples.push_back({entry.lamp, place[node], entry.light});
    }
    sort_stably(tile.samples, {}, &Sample::lamp);
    std::size_t count = 0;
    for (const Sample& sample : tile.samples)
        if (count > 0 && tile.samples[count - 1].lamp == sample.lamp)
            for (std::size_t c = 0; c < 3; ++c) tile.samples[count - 1].light[c] += sample.light[c];
        else
            tile.samples[count++] = sample;
    tile.samples.resize(count);
    tile.samples.shrink_to_fit();
}

/// Makes the least squares of all cells; products: see above, around each cell; light: around each
/// tile.
void SmoothCrowds::prepare(const CellSums& around_cells, const CellSums& around_tiles) {
    solvers_.resize(around_cells.columns * around_cells.rows);
    run_parallel(around_cells.rows, threads_, [&](std::size_t row) {
        for (std::size_t column = 0; column < around_cells.columns; ++column)
            for (std::size_t c = 0; c < 3; ++c) {
                const double* const sums = around_cells.at(column, row) + c * products;
                Solver& solver = solvers_[row * around_cells.columns + column][c];
                const double weight = sums[0];
                if (weight == 0) continue;
                solver.inverse_of_weight = static_cast<float>(1 / weight);
                std::array<double, slopes> means{};
                for (std::size_t i = 0; i < slopes; ++i) {
                    means[i] = sums[i + 1] / weight;
                    solver.means[i] = static_cast<float>(means[i]);
                }
                // Covariances of the terms but the first, with the light as weights.
                std::array<double, slopes * slopes> matrix{};
                const double* product = sums + terms;
                for (std::size_t i = 0; i < slopes; ++i)
                    for (std::size_t j = i; j < slopes; ++j) {
                        const double own = *product++ / weight - means[i] * means[j];
                        matrix[i * slopes + j] = matrix[j * slopes + i] = own;
                    }
                for (std::size_t i = 0; i < slopes; ++i) matrix[i * slopes + i] += ridge;
                if (!invert<slopes>(matrix)) continue;
                for (std::size_t i = 0; i < matrix.size(); ++i)
                    solver.inverse[i] = static_cast<float>(matrix[i]);
            }
    });
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
        auto& inverse = inverse_light_around_tiles_.emplace_back();
        const double* const light = around_tiles.at(i % columns_, i / columns_);
        for (std::size_t c = 0; c < 3; ++c)
            inverse[c] = light[c] == 0 ? 0 : static_cast<float>(1 / light[c]);
    }
}

SmoothCrowds::Fit SmoothCrowds::fitted(const FactorMeans& means,
                                       std::span<const Vec3> factors) const {
    CellSums of_cells(along * columns_, along * rows_, 3 * terms), of_tiles(columns_, rows_, 3);
    Fit fit;
    fit.least.resize(tiles_.size());
    fit.most.resize(tiles_.size());
    run_parallel(tiles_.size(), threads_, [&](std::size_t number) {
        const Tile& tile = tiles_[number];
        std::vector<Vec3> mean_of;
        NodeSums all{};
        constexpr std::size_t of_channel = cells_of_tile * terms;
        for (std::size_t n = 0; n < tile.nodes.size(); ++n) {
            const Vec3 mean = means(records_.tiles[number].nodes[tile.nodes[n]]);
            mean_of.push_back(mean);
            for (std::size_t c = 0; c < 3; ++c) {
                const auto by = static_cast<float>(mean[static_cast<int>(c)]);
                float& least = fit.least[number][c];
                float& most = fit.most[number][c];
                least = n == 0 ? by : std::min(least, by);
                most = n == 0 ? by : std::max(most, by);
                if (by == 0) continue;
                const float* const from = &tile.sums[n][c * of_channel];
                float* const to = &all[c * of_channel];
                for (std::size_t i = 0; i < of_channel; ++i) to[i] += by * from[i];
            }
        }
        for (std::size_t i = 0; i < cells_of_tile; ++i) {
            double* const to = of_cells.at(number % columns_ * along + i % along,
                                           number / columns_ * along + i / along);
            for (std::size_t c = 0; c < 3; ++c)
                for (std::size_t t = 0; t < terms; ++t)
                    to[c * terms + t] = static_cast<double>(all[c * of_channel + i * terms + t]);
        }
        double* const extra = of_tiles.at(number % columns_, number / columns_);
        for (const Sample& sample : tile.samples) {
            const Vec3 off = factors[sample.lamp] - mean_of[sample.node];
            for (int c = 0; c < 3; ++c)
                extra[c] += off[c] * static_cast<double>(sample.light[static_cast<std::size_t>(c)]);
        }
    });
    blur(of_cells, radius_ / cell, threads_);
    blur(of_tiles, wider_for_samples * radius_ / light_tile, threads_);
    fit.cells.resize(solvers_.size());
    run_parallel(of_cells.rows, threads_, [&](std::size_t row) {
        for (std::size_t column = 0; column < of_cells.columns; ++column) {
            const double* const sums = of_cells.at(column, row);
            const std::size_t number = row * of_cells.columns + column;
            for (std::size_t c = 0; c < 3; ++c) {
                const Solver& solver = solvers_[number][c];
                std::array<float, terms> ratio{};
                for (std::size_t t = 0; t < terms; ++t)
                    ratio[t] = static_cast<float>(sums[c * terms + t]) * solver.inverse_of_weight;
                float* const to = &fit.cells[number][c * terms];
                to[0] = ratio[0];
                for (std::size_t i = 0; i < slopes; ++i) {
                    float slope = 0;
                    for (std::size_t j = 0; j < slopes; ++j)
                        slope += solver.inverse[i * slopes + j] *
                                 (ratio[j + 1] - solver.means[j] * ratio[0]);
                    to[i + 1] = slope;
                    to[0] -= slope * solver.means[i];
                }
            }
        }
    });
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
        auto& extra = fit.tiles.emplace_back();
        const double* const light = of_tiles.at(i % columns_, i / columns_);
        for (std::size_t c = 0; c < 3; ++c)
            extra[c] = static_cast<float>(light[c]) * inverse_light_around_tiles_[i][c];
    }
    return fit;
}

void SmoothCrowds::add(const Fit& fit, std::size_t number, TilePlanes& planes) const {
    const Tile& tile = tiles_[number];
    if (tile.nodes.empty()) return;
    static constexpr auto between_cells = interpolation<along>();
    static constexpr auto between_tiles = interpolation<1>();
    constexpr std::size_t side = light_tile, near_cells = along + 2, near_tiles = 3;
    const std::size_t column = number % columns_, row = number / columns_;
    const std::size_t cell_columns = along * columns_, cell_rows = along * rows_;
    for (std::size_t y = 0; y < side; ++y) {
        // The fits of this row of pixels, at the centres of the cells around.
        std::array<std::array<float, 3 * terms>, near_cells> fits{};
        for (std::size_t j = 0; j < near_cells; ++j) {
            const float weight = between_cells[j][y];
            if (weight == 0) continue;
            const std::size_t first = within(along * row + j, 1, cell_rows) * cell_columns;
            for (std::size_t i = 0; i < near_cells; ++i) {
                const auto& from = fit.cells[first + within(along * column + i, 1, cell_columns)];
                for (std::size_t k = 0; k < from.size(); ++k) fits[i][k] += weight * from[k];
            }
        }
        std::array<std::array<float, 3>, near_tiles> extras{};
        for (std::size_t j = 0; j < near_tiles; ++j) {
            const std::size_t first = within(row + j, 1, rows_) * columns_;
            for (std::size_t i = 0; i < near_tiles; ++i)
                for (std::size_t c = 0; c < 3; ++c)
                    extras[i][c] +=
                        between_tiles[j][y] * fit.tiles[first + within(column + i, 1, columns_)][c];
        }
        std::array<std::array<float, side>, terms> term{};
        for (std::size_t x = 0; x < side; ++x) {
            const auto own = terms_of(number, y * side + x);
            for (std::size_t t = 0; t < terms; ++t) term[t][x] = own[t];
        }
        for (std::size_t c = 0; c < 3; ++c) {
            std::array<float, side> ratio{};
            for (std::size_t t = 0; t < terms; ++t) {
                std::array<float, side> factor{};
                for (std::size_t i = 0; i < near_cells; ++i)
                    for (std::size_t x = 0; x < side; ++x)
                        factor[x] += between_cells[i][x] * fits[i][c * terms + t];
                for (std::size_t x = 0; x < side; ++x) ratio[x] += factor[x] * term[t][x];
            }
            // The light of a pixel is a mean of that of its nodes.
            for (std::size_t x = 0; x < side; ++x)
                ratio[x] = std::clamp(ratio[x], fit.least[number][c], fit.most[number][c]);
            for (std::size_t i = 0; i < near_tiles; ++i)
                for (std::size_t x = 0; x < side; ++x)
                    ratio[x] += between_tiles[i][x] * extras[i][c];
            const std::size_t first = c * tile_pixels + y * side;
            for (std::size_t x = 0; x < side; ++x)
                planes[first + x] += tile.usual[first + x] * std::max(ratio[x], 0.0F);
        }
    }
}

}  // namespace candelabra
