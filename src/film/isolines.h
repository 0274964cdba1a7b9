// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of equal value in a picture of numbers, such as lines of equal illuminance.
#pragma once

#include "base/image.h"

#include <functional>
#include <string>
#include <vector>

namespace candelabra {

/// A line along which a field has one value. Points are in pixels; that of a pixel's middle is
/// (x + 0.5, y + 0.5).
struct Isoline {
    double value;
    std::vector<Vec2> points;  ///< at least two; a closed line ends where it begins
    double length;             ///< in pixels
};

/// A number for each pixel, row by row from the top.
struct NumberField {
    int width = 0, height = 0;
    std::vector<double> numbers;

    double at(int x, int y) const {
        return numbers[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(x)];
    }
};

/// The red channel without its noise: averages over pixels that differ no more than noise does
/// there. Steps that are higher remain, and a field without noise remains what it is. Pixels that
/// are not finite have the middle value of their neighbours, or 0.
NumberField calmed(const Image& values);

/// The lines of the values step, 2 step ... up to `most`, shortest ones left out. Where the field
/// jumps by more than a step from pixel to pixel, as at the edge of an object, there are none.
std::vector<Isoline> isolines_of(const NumberField&, double step, double most, double shortest);

struct IsolineLook {
    int size = 1;  ///< of letters and lines; see write_text()
    std::function<Rgb(double value)> colour;
    std::function<std::string(double value)> text;
};

/// Draws the lines, smoothly between the pixels, and the numbers of long ones in gaps of them.
/// Nothing is drawn below the row `bottom`.
void draw_isolines(const std::vector<Isoline>&, const IsolineLook&, int bottom, Image& picture);

}  // namespace candelabra
