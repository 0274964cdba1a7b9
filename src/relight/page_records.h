// SPDX-License-Identifier: GPL-3.0-or-later
// The light of lamps in few bytes, for pages that play shows in a browser
// (src/preview/page/show.js has the decoder).
//
// A pixel is: light without a lamp; that of a few strong lamps, which have layers; light of crowds,
// which becomes so many times more or less as it does in the cell of 16x16 pixels around it; and
// dots: light of single lamps that their cells do not tell, such as lamps that are seen. A lamp
// with dots has its light in no cell, as far as it is known by itself. Cells have nodes of lamps
// with their shares of the light; between the centres of cells the factor is interpolated.
//
// Numbers without a sign are varints (7 bits a byte, the lowest first), others zigzag varints, and
// light has 16 bits: 2048 log2(1 + 64 v). Cells, row by row: the number of nodes, and of each the
// gap before it, its number of lamps, and its shares of red, green and blue in 1/65535 (u16). Dots,
// row by row: the gap to the pixel, the step from the last lamp, and three lights. Powers: a float
// of each lamp.
#pragma once

#include "base/image.h"
#include "camera/film_settings.h"
#include "relight/light_records.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace candelabra {

inline constexpr int page_cell = 16;

struct PageRecords {
    std::vector<std::uint32_t> strong;  ///< places of the lamps that have layers
    /// That of crowds, that without a lamp, and those of the strong lamps, as they fall on the
    /// film, with its glare and vignette.
    std::vector<Image> layers;
    int columns = 0, rows = 0;
    std::string cells, dots, powers;
};

/// `most_dots`: those of the lamps are kept that matter most.
PageRecords page_records(const LightRecords&, const FilmSettings&, std::size_t most_dots,
                         int threads);

}  // namespace candelabra
