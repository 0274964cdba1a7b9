// SPDX-License-Identifier: GPL-3.0-or-later
// What a picture file says of itself that its pixels do not tell: the table of colours that PNG and
// GIF files number, and whether a PNG file says how its values are coded. Called by the readers of
// pictures and of heights.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

struct FileFacts {
    /// Red, green, blue, alpha, as bytes. Empty: the file has no table.
    std::vector<std::array<std::uint8_t, 4>> table;
    /// Of a PNG file, that it says the gamma of its values or that they are sRGB. Nothing for other
    /// files.
    std::optional<bool> says_coding;
};

/// Of a file that cannot be read: nothing.
FileFacts file_facts(const std::string& path);

/// The number of the first colour of the table that is the pixel's: one value, or three, from 0 to
/// 1, with its alpha. The table's size when there is none.
std::size_t number_in(const FileFacts&, std::span<const float> pixel, float alpha);
