// SPDX-License-Identifier: GPL-3.0-or-later
// The light of each lamp in a tile of 8x8 pixels, as a file keeps it and pictures are relit with
// it: some nodes of lamps with their light in each pixel, single records of lamps, and a sample of
// single records that says how the lamps of a node differ.
//
// With factors w on the lamps and their means m over the lamps of each node, a pixel is
//     rest + sum over nodes (light * m) + sum over own (light * w)
//          + sum over residual (light * (w - m of the lamp's node)).
// With equal factors the residual is 0; in other cases it gives the sum the right expected value.
#pragma once

#include "relight/lamp_cut.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// Pixels of a tile along its sides.
inline constexpr int light_tile = 8;
inline constexpr std::size_t tile_pixels = std::size_t{light_tile} * light_tile;

/// Three planes of a tile: red, green and blue.
using TilePlanes = std::array<float, 3 * tile_pixels>;

struct TileRecords {
    std::vector<LampRange> nodes;      ///< disjoint, in the order of the list
    std::vector<std::uint16_t> light;  ///< of each node: planes of halves, to be multiplied by...
    float scale = 1;                   ///< ...this
    std::vector<LampEntry> own;        ///< lamps in no node, or that a ray met, by pixel and lamp
    std::vector<LampEntry> residual;   ///< of lamps in nodes, by pixel and lamp
    std::optional<TilePlanes> rest;    ///< light without a lamp; none: there is none
    bool seen_in_nodes = false;        ///< nodes have light of lamps that rays met: it is sharp

    friend bool operator==(const TileRecords&, const TileRecords&) = default;
};

/// Most bytes that a node, an entry, the rest and anything else take in a file.
inline constexpr std::size_t node_bytes = 2 * 3 * tile_pixels + 10;
inline constexpr std::size_t entry_bytes = 13;
inline constexpr std::size_t rest_bytes = sizeof(TilePlanes);
inline constexpr std::size_t tile_head_bytes = 32;

/// Rounds light to what a file keeps.
void round_to_file(TileRecords&, const std::vector<TilePlanes>& light_of_nodes);

/// Appends the bytes of a tile.
void append_tile(std::string& bytes, const TileRecords&);

/// Takes a tile from the front of the bytes. Returns nothing if they are not those of a tile with
/// this number of lamps.
std::optional<TileRecords> take_tile(std::string_view& bytes, std::uint32_t lamps);

}  // namespace candelabra
