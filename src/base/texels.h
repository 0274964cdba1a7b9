// SPDX-License-Identifier: GPL-3.0-or-later
// A picture as patterns ask it: values that have their final coding, transparency, and the numbers
// of the colours where the file has a table of them. Made by picture/, kept by patterns.
#pragma once

#include "base/colour.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace candelabra {

struct Texels {
    int width = 0, height = 0;
    int channels = 3;           ///< 1: grey, or 3
    std::vector<float> values;  ///< row by row from the top, channels side by side; empty where
                                ///< there are numbers
    std::vector<float> alpha;   ///< of each pixel; empty: opaque
    std::vector<std::uint16_t> numbers;  ///< of each pixel's colour in the table; empty: no table
    std::vector<Colour> table;
    Vec3 greatest = Vec3(0);  ///< of all values, per channel; filled by whoever makes the texels

    /// Fills in the greatest values.
    void measure() {
        for (const Colour& colour : table) greatest = glm::max(greatest, colour.rgb);
        const auto step = static_cast<std::size_t>(channels);
        for (std::size_t i = 0; i + step <= values.size(); i += step)
            greatest =
                glm::max(greatest, Vec3(values[i], values[i + step / 2], values[i + step - 1]));
    }

    bool transparent() const { return !alpha.empty(); }
    /// The place of a pixel in the lists above.
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

}  // namespace candelabra
