// SPDX-License-Identifier: GPL-3.0-or-later
// The light of crowds of lamps under other powers, with little noise: how much more or less it is
// than in the picture that was rendered is fitted to the surroundings of each pixel.
//
// Samples choose among all lamps, so the light of a node in one pixel is noisy, and so is the light
// of a pixel where nodes are dimmed differently. The ratio of a pixel's light to that which was
// rendered is smooth. It is fitted by least squares with the light rendered as weights, as a linear
// function of the normal and of the place in the picture: for a matte surface without shadows the
// light of each lamp is linear in the normal. Cf. B. Moon et al., "Adaptive Rendering Based on
// Weighted Local Regression", ACM TOG 33 (2014), and K. He, J. Sun, "Fast Guided Filter", 2015, for
// the cells in which it is done. What samples say of the lamps within a node is smaller, noisier
// and smoother, and averaged over wider surroundings, unless it differs from them. Tiles with nodes
// that have lamps which are seen are left out: what is seen changes from pixel to pixel.
#pragma once

#include "relight/cell_sums.h"
#include "relight/factor_means.h"
#include "relight/light_records.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace candelabra {

class SmoothCrowds {
public:
    /// `radius`: about how far around a pixel the ratio is fitted, in pixels, from 1 on. The
    /// records must outlive it.
    SmoothCrowds(const LightRecords&, int radius, int threads);

    /// The terms of a fit: 1, the three components of the normal, and the place in the picture.
    static constexpr std::size_t terms = 6;

    /// What is fitted under some factors.
    struct Fit {
        /// Of each cell, red, green and blue: factors of the terms.
        std::vector<std::array<float, 3 * terms>> cells;
        /// Of each tile: what is added to the ratio.
        std::vector<Channels> tiles;
        /// Of each tile: the least and the greatest factor on one of its nodes.
        std::vector<Channels> least, most;
    };
    /// `factors`: those of the means.
    Fit fitted(const FactorMeans&, std::span<const Channels> factors) const;

    /// Adds the light of the crowds of a tile to its planes, unless it is left out.
    void add(const Fit&, std::size_t tile, TilePlanes&) const;

private:
    static constexpr std::size_t along = 2;  ///< cells along a side of a tile
    static constexpr int cell = light_tile / static_cast<int>(along);
    static constexpr std::size_t cells_of_tile = along * along;
    static constexpr std::size_t slopes = terms - 1;

    /// Of one node in a tile: sums over each cell of light, times each term, channel by channel.
    using NodeSums = std::array<float, 3 * cells_of_tile * terms>;

    struct Node {
        LampRange lamps;
        NodeSums sums{};
        Channels samples{};  ///< their light
    };
    /// Samples of one lamp in all pixels of a tile.
    struct Sample {
        std::uint32_t lamp = 0, column = 0;  ///< that of the tile
        Channels light{};
    };
    struct Tile {
        std::vector<Node> nodes;  ///< those with several lamps
        TilePlanes usual{};    ///< light as rendered
        TilePlanes normals{};  ///< of the pixels
    };
    /// The least squares of a channel of a cell.
    struct Solver {
        float inverse_of_weight = 0;
        std::array<float, slopes> means{};
        std::array<float, slopes * slopes> inverse{};
    };

    void take(std::size_t number);
    void take_samples(std::size_t row);
    void sum(std::size_t tile, const FactorMeans&, Fit&, CellSums& of_cells,
             CellSums& of_tiles) const;
    void prepare(const CellSums& products, const CellSums& light);
    std::array<float, terms> terms_of(std::size_t tile, std::size_t pixel) const;

    const LightRecords& records_;
    double radius_;
    float per_pixel_;  ///< place of a pixel in terms of the radius
    int threads_;
    std::size_t columns_, rows_;  ///< of tiles
    std::vector<Tile> tiles_;
    std::vector<std::vector<Sample>> samples_;  ///< of each row of tiles, by lamp and column
    std::vector<std::array<Solver, 3>> solvers_;                    ///< of cells
    std::vector<Channels> light_of_;  ///< of crowds in tiles, as rendered
    std::vector<Channels> inverse_light_around_tiles_;              ///< 0: there is none
};

}  // namespace candelabra
