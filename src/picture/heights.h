// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures as heights, by POV-Ray's rules: greys by their brightness, 8-bit colours by red as the
// high byte and green as the low byte, indexed colours by their indices. Called for height fields.
#pragma once

#include "text/diagnostic.h"
#include "text/loader.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace candelabra {

struct Heights {
    int width = 0, height = 0;
    std::vector<std::uint16_t> values;  ///< row by row from the bottom of the picture
};

/// Returns the heights, or nothing with a diagnostic at the span. The values are taken as they are
/// stored, unless `gamma` is above 0: then they are raised to that power first.
std::optional<Heights> read_heights(const Found&, double gamma, Diagnostics&, Span asked_at = {});

/// Decodes the heights of a potential as Fractint writes it: colour indices in the left half of the
/// picture are the high bytes, those in the right half the low bytes.
Heights of_two_halves(const Heights&);

}  // namespace candelabra
