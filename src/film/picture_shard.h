// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a picture that a run makes: a rectangle, some of its tiles, or some of the samples of
// each pixel. Used by the renderer, checkpoints and merging.
#pragma once

#include <algorithm>
#include <cstdint>

namespace candelabra {

/// Edge length of tiles in pixels. As in POV-Ray, whose antialiasing does not look beyond a tile.
inline constexpr int tile_size = 32;

/// A rectangle in pixels from the left and top edge; the right and lower edges are excluded.
struct Region {
    int left = 0, top = 0, right = 0, bottom = 0;

    bool contains(int x, int y) const { return x >= left && x < right && y >= top && y < bottom; }
    friend bool operator==(const Region&, const Region&) = default;
};

/// Returns the intersection; empty if a side is not before its opposite.
inline Region common(const Region& a, const Region& b) {
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
            std::min(a.bottom, b.bottom)};
}

struct PictureShard {
    Region region;
    /// Every tile_step-th tile from first_tile on, counted row by row.
    int first_tile = 0, tile_step = 1;
    /// Number of the first sample of each pixel.
    std::uint32_t first_sample = 0;
    int width = 0;  ///< of the whole picture

    /// Whether the pixel belongs to this shard.
    bool owns(int x, int y) const {
        if (!region.contains(x, y)) return false;
        const int tiles = (width + tile_size - 1) / tile_size;
        return tile_step == 1 || (y / tile_size * tiles + x / tile_size) % tile_step == first_tile;
    }
    friend bool operator==(const PictureShard&, const PictureShard&) = default;
};

inline PictureShard whole_picture(int width, int height) {
    return {{0, 0, width, height}, 0, 1, 0, width};
}

}  // namespace candelabra
