// SPDX-License-Identifier: GPL-3.0-or-later
// The fields whose values POV-Ray renders outside of their ranges. There a value that it would
// refuse is an error, and one that it renders is a warning. Asked by the ItemReader.
#pragma once

#include "vocabulary/item_info.h"

#include <string_view>

namespace candelabra {

/// What counts instead of a value outside of the range of a field.
struct RenderedRange {
    std::string_view item, field;
    double least;           ///< instead of a value below the range
    bool any_sign = false;  ///< instead: its absolute value, if that is in the range
    bool always = false;    ///< `least` counts also instead of a value above the range
    double wraps = 0;       ///< instead: a number that differs by a multiple of this
};

/// Null if a value outside of the field's range is an error.
const RenderedRange* rendered_range(std::string_view item, std::string_view field);

/// Replaces the numbers that are outside of a range; those above it become its high end. Returns
/// one that has been replaced.
double bring_into(const Range&, const RenderedRange&, FieldValue&);

}  // namespace candelabra
