// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/plate_text.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace candelabra {

namespace {

constexpr int letter_width = 5, letter_step = 6;

/// Rows from the top; the highest of five bits is the left column.
struct Letter {
    char character;
    std::array<std::uint8_t, letter_height> rows;
};

constexpr auto letters = std::to_array<Letter>({
    {'0', {0b01110, 0b10001, 0b10011, 0b10101, 0b11001, 0b10001, 0b01110}},
    {'1', {0b00100, 0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110}},
    {'2', {0b01110, 0b10001, 0b00001, 0b00110, 0b01000, 0b10000, 0b11111}},
    {'3', {0b11110, 0b00001, 0b00001, 0b01110, 0b00001, 0b00001, 0b11110}},
    {'4', {0b00010, 0b00110, 0b01010, 0b10010, 0b11111, 0b00010, 0b00010}},
    {'5', {0b11111, 0b10000, 0b11110, 0b00001, 0b00001, 0b10001, 0b01110}},
    {'6', {0b00110, 0b01000, 0b10000, 0b11110, 0b10001, 0b10001, 0b01110}},
    {'7', {0b11111, 0b00001, 0b00010, 0b00100, 0b01000, 0b01000, 0b01000}},
    {'8', {0b01110, 0b10001, 0b10001, 0b01110, 0b10001, 0b10001, 0b01110}},
    {'9', {0b01110, 0b10001, 0b10001, 0b01111, 0b00001, 0b00010, 0b01100}},
    {'.', {0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b01100, 0b01100}},
    {'-', {0b00000, 0b00000, 0b00000, 0b11111, 0b00000, 0b00000, 0b00000}},
    {'+', {0b00000, 0b00100, 0b00100, 0b11111, 0b00100, 0b00100, 0b00000}},
    {'/', {0b00001, 0b00001, 0b00010, 0b00100, 0b01000, 0b10000, 0b10000}},
    {'%', {0b11001, 0b11001, 0b00010, 0b00100, 0b01000, 0b10011, 0b10011}},
    {'e', {0b00000, 0b00000, 0b01110, 0b10001, 0b11111, 0b10000, 0b01110}},
    {'l', {0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110}},
    {'x', {0b00000, 0b00000, 0b10001, 0b01010, 0b00100, 0b01010, 0b10001}},
    {'c', {0b00000, 0b00000, 0b01110, 0b10000, 0b10000, 0b10001, 0b01110}},
    {'d', {0b00001, 0b00001, 0b01101, 0b10011, 0b10001, 0b10001, 0b01111}},
    {'m', {0b00000, 0b00000, 0b11010, 0b10101, 0b10101, 0b10101, 0b10101}},
});

}  // namespace

int text_width(std::string_view text, int size) {
    return letter_step * size * static_cast<int>(text.size());
}

void write_text(Image& picture, PixelPlace at, std::string_view text, int size, const Rgb& colour) {
    for (const char c : text) {
        const auto letter = std::ranges::find(letters, c, &Letter::character);
        for (int row = 0; letter != letters.end() && row < letter_height * size; ++row)
            for (int column = 0; column < letter_width * size; ++column) {
                const int bit = letter_width - 1 - column / size;
                const int x = at.x + column, y = at.y + row;
                const bool inside = x >= 0 && y >= 0 && x < picture.width && y < picture.height;
                if (inside && (letter->rows[static_cast<std::size_t>(row / size)] >> bit & 1) != 0)
                    picture.at(x, y) = colour;
            }
        at.x += letter_step * size;
    }
}

}  // namespace candelabra
