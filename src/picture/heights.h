// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures as heights, by POV-Ray's rules: grey by its brightness, colours of 8 bits by red and
// green as high and low byte, numbered colours by their numbers. Called for height fields.
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

/// The heights, or nothing with a diagnostic at the span. The values are taken as they are stored,
/// unless there is a gamma (above 0).
std::optional<Heights> read_heights(const Found&, double gamma, Diagnostics&, Span asked_at = {});

}  // namespace candelabra
