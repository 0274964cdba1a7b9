// SPDX-License-Identifier: GPL-3.0-or-later
// What a picture file says of itself that its pixels do not tell: the table of colours that PNG,
// GIF and Targa files number, and whether a PNG file says how its values are coded. Called by the
// readers of pictures and of heights.
#pragma once

#include "text/loader.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace candelabra {

struct FileFacts {
    /// Red, green, blue, alpha, as bytes. Empty: the file has no table.
    std::vector<std::array<std::uint8_t, 4>> table;
    /// Of a PNG file, that it says the gamma of its values or that they are sRGB. Nothing for other
    /// files.
    std::optional<bool> says_coding;
};

/// Of a file that is none of these, or damaged: nothing.
FileFacts file_facts(const Found&);

/// The colours of a table by their bytes, so that each of many pixels is found fast.
class ColourNumbers {
public:
    explicit ColourNumbers(const FileFacts&);

    /// The number of the first colour of the table that is the pixel's: one value, or three, from 0
    /// to 1, with its alpha. The table's size when there is none.
    std::size_t operator()(std::span<const float> pixel, float alpha) const;

private:
    std::size_t none_;
    std::unordered_map<std::uint32_t, std::size_t> numbers_;
};

}  // namespace candelabra
