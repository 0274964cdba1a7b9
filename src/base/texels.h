// SPDX-License-Identifier: GPL-3.0-or-later
// A picture in the form that patterns use: decoded values, transparency, and colour indices if the
// file has a colour table. Made by picture/, kept by patterns.
#pragma once

#include "base/colour.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace candelabra {

struct Texels {
    int width = 0, height = 0;
    int channels = 3;           ///< 1: grey, or 3
    std::vector<float> values;  ///< row by row from the top, channels interleaved; empty if there
                                ///< are colour indices
    std::vector<float> alpha;   ///< one per pixel; empty: opaque
    std::vector<std::uint16_t> numbers;  ///< colour index of each pixel; empty: no table
    std::vector<Colour> table;
    Rgb greatest;  ///< maximum of all values, per channel; set by measure()

    /// Sets the greatest values.
    void measure() {
        for (const Colour& colour : table) greatest = max(greatest, colour.rgb);
        const auto step = static_cast<std::size_t>(channels);
        for (std::size_t i = 0; i + step <= values.size(); i += step)
            greatest = max(greatest, Rgb(values[i], values[i + step / 2], values[i + step - 1]));
    }

    bool transparent() const { return !alpha.empty(); }
    /// Index of a pixel in the lists above.
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

}  // namespace candelabra
