// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/smooth_crowds.h"

#include "base/order.h"
#include "base/parallel.h"
#include "base/target_clones.h"
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

constexpr auto between_cells = interpolation<2>();
constexpr auto between_tiles = interpolation<1>();

/// What is fitted to a row of pixels in a tile.
struct RowFit {
    /// At the centres of the cells and of the tiles, from the one before to the one behind.
    std::array<std::array<float, 3 * terms>, 4> cells{};
    std::array<Channels, 3> tiles{};
    std::array<std::array<float, light_tile>, terms> term{};  ///< of the pixels
    Channels least{}, most{};
};

/// Adds a node's sums, channel by channel, times its factors.
CANDELABRA_TARGET_CLONES
void add_products(const float* sums, const float* factors, float* all) {
    constexpr std::size_t of_channel = 4 * terms;
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < of_channel; ++i)
            all[c * of_channel + i] += factors[c] * sums[c * of_channel + i];
}

/// What samples add to the ratio in a tile: as in its surroundings, unless its own samples differ
/// from them by more than their noise. `squares`: their sum over the samples; `light`: as rendered.
Channels between(const Channels& inverse_around, const double* around, const double* here,
                 double squares, const Channels& light) {
    constexpr double errors = 2;
    Channels made{}, off{};
    double size = 0, noise = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        made[c] = static_cast<float>(around[c]) * inverse_around[c];
        if (light[c] > 0) off[c] = static_cast<float>(here[c]) / light[c] - made[c];
        size += static_cast<double>(off[c]) * static_cast<double>(off[c]);
        noise = std::max(noise, static_cast<double>(light[c]));
    }
    noise = noise > 0 ? squares / (noise * noise) : 0;
    const double share = size > 0 ? 1 - errors * errors * noise / size : 0;
    for (std::size_t c = 0; c < 3; ++c)
        made[c] += static_cast<float>(std::max(share, 0.0)) * off[c];
    return made;
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
      per_pixel_(static_cast<float>(1 / radius_)),
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
    samples_.resize(rows_);
    run_parallel(rows_, threads_, [&](std::size_t row) { take_samples(row); });
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
        const double* const light = of_tiles.at(i % columns_, i / columns_);
        light_of_.push_back({static_cast<float>(light[0]), static_cast<float>(light[1]),
                             static_cast<float>(light[2])});
    }
    blur(of_cells, radius_ / cell, threads_);
    blur(of_tiles, wider_for_samples * radius_ / light_tile, threads_);
    prepare(of_cells, of_tiles);
}

std::array<float, terms> SmoothCrowds::terms_of(std::size_t tile, std::size_t pixel) const {
    const TilePlanes& normals = tiles_[tile].normals;
    const auto place = [&](std::size_t number, std::size_t in_tile) {
        return static_cast<float>(number * light_tile + in_tile) * per_pixel_;
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
    for (std::size_t n = 0; n < from.nodes.size(); ++n) {
        if (from.nodes[n].size() == 1 || from.seen_in_nodes) continue;
        NodeSums& sums = tile.nodes.emplace_back(Node{from.nodes[n]}).sums;
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
}

/// Takes the samples of a row of tiles. In the order of lamps their factors are found soon.
void SmoothCrowds::take_samples(std::size_t row) {
    std::vector<Sample>& samples = samples_[row];
    for (std::size_t column = 0; column < columns_; ++column) {
        std::vector<Node>& nodes = tiles_[row * columns_ + column].nodes;
        if (nodes.empty()) continue;
        for (const LampEntry& entry : records_.tiles[row * columns_ + column].residual) {
            const auto after = std::ranges::upper_bound(
                nodes, entry.lamp, {}, [](const Node& node) { return node.lamps.first; });
            for (std::size_t c = 0; c < 3; ++c) after[-1].samples[c] += entry.light[c];
            samples.push_back({entry.lamp, static_cast<std::uint32_t>(column), entry.light});
        }
    }
    sort_stably(samples, {},
                [](const Sample& each) { return std::uint64_t{each.lamp} << 32 | each.column; });
    std::size_t count = 0;
    for (const Sample& sample : samples)
        if (count > 0 && samples[count - 1].lamp == sample.lamp &&
            samples[count - 1].column == sample.column)
            for (std::size_t c = 0; c < 3; ++c) samples[count - 1].light[c] += sample.light[c];
        else
            samples[count++] = sample;
    samples.resize(count);
    samples.shrink_to_fit();
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

/// Sums the light of a tile under some factors by cells, and what its samples add.
void SmoothCrowds::sum(std::size_t number, const FactorMeans& means, Fit& fit, CellSums& of_cells,
                       CellSums& of_tiles) const {
    const Tile& tile = tiles_[number];
    NodeSums all{};
    Channels& least = fit.least[number];
    Channels& most = fit.most[number];
    double* const extra = of_tiles.at(number % columns_, number / columns_);
    for (std::size_t n = 0; n < tile.nodes.size(); ++n) {
        const Node& node = tile.nodes[n];
        const Channels mean = channels(means(node.lamps));
        add_products(node.sums.data(), mean.data(), all.data());
        for (std::size_t c = 0; c < 3; ++c) {
            least[c] = n == 0 ? mean[c] : std::min(least[c], mean[c]);
            most[c] = n == 0 ? mean[c] : std::max(most[c], mean[c]);
            extra[c] -= static_cast<double>(mean[c]) * static_cast<double>(node.samples[c]);
        }
    }
    for (std::size_t i = 0; i < cells_of_tile; ++i) {
        double* const to = of_cells.at(number % columns_ * along + i % along,
                                       number / columns_ * along + i / along);
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t t = 0; t < terms; ++t)
                to[c * terms + t] = static_cast<double>(all[(c * cells_of_tile + i) * terms + t]);
    }
}

SmoothCrowds::Fit SmoothCrowds::fitted(const FactorMeans& means,
                                       std::span<const Channels> factors) const {
    CellSums of_cells(along * columns_, along * rows_, 3 * terms), of_tiles(columns_, rows_, 3);
    std::vector<double> squares(tiles_.size());
    Fit fit;
    fit.least.resize(tiles_.size());
    fit.most.resize(tiles_.size());
    run_parallel(rows_, threads_, [&](std::size_t row) {
        for (const Sample& sample : samples_[row]) {
            const Channels& factor = factors[sample.lamp];
            double* const extra = of_tiles.at(sample.column, row);
            float square = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const float light = factor[c] * sample.light[c];
                extra[c] += static_cast<double>(light);
                square += light * light;
            }
            squares[row * columns_ + sample.column] += static_cast<double>(square);
        }
        for (std::size_t column = 0; column < columns_; ++column)
            sum(row * columns_ + column, means, fit, of_cells, of_tiles);
    });
    const CellSums own = of_tiles;
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
        const double *const around = of_tiles.at(i % columns_, i / columns_), *const here = own.at(
                                                                                  i % columns_,
                                                                                  i / columns_);
        fit.tiles.push_back(
            between(inverse_light_around_tiles_[i], around, here, squares[i], light_of_[i]));
    }
    return fit;
}

namespace {

/// Adds the light of a row of pixels of a tile.
CANDELABRA_TARGET_CLONES
void add_row(const RowFit& fit, const float* usual, float* light) {
    constexpr std::size_t side = light_tile;
    for (std::size_t c = 0; c < 3; ++c) {
        std::array<float, side> ratio{};
        for (std::size_t t = 0; t < terms; ++t) {
            std::array<float, side> factor{};
            for (std::size_t i = 0; i < fit.cells.size(); ++i)
                for (std::size_t x = 0; x < side; ++x)
                    factor[x] += between_cells[i][x] * fit.cells[i][c * terms + t];
            for (std::size_t x = 0; x < side; ++x) ratio[x] += factor[x] * fit.term[t][x];
        }
        // The light of a pixel is a mean of that of its nodes.
        const float least = fit.least[c], most = fit.most[c];
        for (std::size_t x = 0; x < side; ++x) {
            const float above = ratio[x] < least ? least : ratio[x];
            ratio[x] = above > most ? most : above;
        }
        for (std::size_t i = 0; i < fit.tiles.size(); ++i)
            for (std::size_t x = 0; x < side; ++x)
                ratio[x] += between_tiles[i][x] * fit.tiles[i][c];
        for (std::size_t x = 0; x < side; ++x)
            light[c * tile_pixels + x] +=
                usual[c * tile_pixels + x] * (ratio[x] > 0 ? ratio[x] : 0.0F);
    }
}

}  // namespace

void SmoothCrowds::add(const Fit& fit, std::size_t number, TilePlanes& planes) const {
    const Tile& tile = tiles_[number];
    if (tile.nodes.empty()) return;
    constexpr std::size_t side = light_tile;
    const std::size_t column = number % columns_, row = number / columns_;
    const std::size_t cell_columns = along * columns_, cell_rows = along * rows_;
    for (std::size_t y = 0; y < side; ++y) {
        RowFit here;
        here.least = fit.least[number];
        here.most = fit.most[number];
        for (std::size_t j = 0; j < here.cells.size(); ++j) {
            const float weight = between_cells[j][y];
            if (weight == 0) continue;
            const std::size_t first = within(along * row + j, 1, cell_rows) * cell_columns;
            for (std::size_t i = 0; i < here.cells.size(); ++i) {
                const auto& from = fit.cells[first + within(along * column + i, 1, cell_columns)];
                for (std::size_t k = 0; k < from.size(); ++k) here.cells[i][k] += weight * from[k];
            }
        }
        for (std::size_t j = 0; j < here.tiles.size(); ++j) {
            const std::size_t first = within(row + j, 1, rows_) * columns_;
            for (std::size_t i = 0; i < here.tiles.size(); ++i)
                for (std::size_t c = 0; c < 3; ++c)
                    here.tiles[i][c] +=
                        between_tiles[j][y] * fit.tiles[first + within(column + i, 1, columns_)][c];
        }
        for (std::size_t x = 0; x < side; ++x) {
            const auto own = terms_of(number, y * side + x);
            for (std::size_t t = 0; t < terms; ++t) here.term[t][x] = own[t];
        }
        add_row(here, tile.usual.data() + y * side, planes.data() + y * side);
    }
}

}  // namespace candelabra
