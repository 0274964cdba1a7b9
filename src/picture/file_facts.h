// SPDX-License-Identifier: GPL-3.0-or-later
// Facts about a picture file that its decoded pixels do not show: the colour table of PNG, GIF and
// Targa files, and whether a PNG file declares the encoding of its values. Called by the readers of
// pictures and of heights.
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
    /// Red, green, blue and alpha as bytes. Empty if the file has no table.
    std::vector<std::array<std::uint8_t, 4>> table;
    /// For a PNG file: whether it declares the gamma of its values or that they are sRGB. Nothing
    /// for other files.
    std::optional<bool> says_coding;
};

/// Returns empty facts for a file of another format or a damaged one.
FileFacts file_facts(const Found&);

/// Maps the colours of a table to their indices, for fast lookups of many pixels.
class ColourNumbers {
public:
    explicit ColourNumbers(const FileFacts&);

    /// Returns the index of the first colour in the table that equals the pixel's, or the table's
    /// size if there is none. The pixel is one value or three, from 0 to 1, with its alpha.
    std::size_t operator()(std::span<const float> pixel, float alpha) const;

private:
    std::size_t none_;
    std::unordered_map<std::uint32_t, std::size_t> numbers_;
};

}  // namespace candelabra
