// SPDX-License-Identifier: GPL-3.0-or-later
// Colours written as numbers, for editors that show them beside the text and offer a colour picker.
#pragma once

#include "base/vector.h"
#include "editor/edited_file.h"

#include <optional>
#include <string>
#include <vector>

namespace candelabra {

struct Swatch {
    Part place;  ///< from the prefix to the numbers
    Vec3 srgb;   ///< sRGB-encoded, 0 to 1
};

/// Finds `rgb <1, .5, 0>`, `srgb 0.5`, `rgbf <...>` and so on, if their components are plain
/// numbers.
std::vector<Swatch> swatches(const EditedFile&, const Names&);

/// Returns the colour at that place with new red, green and blue; filter and transmit stay
/// unchanged.
std::optional<std::string> recoloured(const EditedFile&, const Names&, Part place,
                                      const Vec3& srgb);

}  // namespace candelabra
