// SPDX-License-Identifier: GPL-3.0-or-later
// The light of each lamp in a whole picture, of which pictures under other powers are made.
#pragma once

#include "relight/kept_meters.h"
#include "relight/lamp_list.h"
#include "relight/tile_records.h"

#include <cstdint>
#include <string>
#include <vector>

namespace candelabra {

struct LightRecords {
    int width = 0, height = 0;
    LampList lamps;
    std::string origin;  ///< program, scene with its digest, options: see description()
    std::string film;    ///< see to_text(const FilmSettings&); empty: none
    KeptMeters meters;
    std::vector<float> alpha;        ///< of each pixel, 0 to 1; empty: none
    /// Of the surfaces that the camera sees first: x, y, z of the mean normal in each pixel, in
    /// 1/127; 0 without a surface. Empty: not known.
    std::vector<std::int8_t> normals;
    std::vector<TileRecords> tiles;  ///< row by row

    int tiles_across() const { return (width + light_tile - 1) / light_tile; }
    int tiles_down() const { return (height + light_tile - 1) / light_tile; }

    friend bool operator==(const LightRecords&, const LightRecords&) = default;
};

}  // namespace candelabra
