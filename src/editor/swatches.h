// SPDX-License-Identifier: GPL-3.0-or-later
// Colours that are written as numbers, for editors that show them beside the text and let people
// choose others.
#pragma once

#include "base/vector.h"
#include "editor/edited_file.h"

#include <optional>
#include <string>
#include <vector>

namespace candelabra {

struct Swatch {
    Part place;  ///< from the word to the numbers
    Vec3 srgb;   ///< encoded, as screens have it; 0 to 1
};

/// `rgb <1, .5, 0>`, `srgb 0.5`, `rgbf <...>` and so on, as far as they are plain numbers.
std::vector<Swatch> swatches(const EditedFile&, const Names&);

/// The colour at that place with other red, green and blue; what it says of transparency stays.
std::optional<std::string> recoloured(const EditedFile&, const Names&, Part place,
                                      const Vec3& srgb);

}  // namespace candelabra
