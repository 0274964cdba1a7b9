// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures that show numbers by colours, with a scale below them: how bright each place is, in lux
// or in candela per square metre.
#pragma once

#include "base/image.h"

#include <string>

namespace candelabra {

struct FalseColours {
    double most = 0;        ///< value at the end of the scale; 0: chosen by the values
    bool isolines = false;  ///< lines of the values of the marks of the scale, with numbers
    std::string unit;       ///< behind the numbers: digits, `lx` and `cd/m2` have letters
};

/// The least of 1, 2 and 5 times the powers of ten that is not below the value, which is above 0.
double round_upward(double value);

/// The end of a scale that fits the values: one of a hundred may lie above it. 1 if all are 0.
double fitting_scale(const Image& values);

/// Display values, from 0 to 1 before the encoding of sRGB, of a picture whose red channel has the
/// values. Values that are not finite are grey, those above the scale light red. The scale is
/// attached below; from dark to light its colours differ for the colour-blind, too.
Image false_coloured(const Image& values, const FalseColours&);

}  // namespace candelabra
