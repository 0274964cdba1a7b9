// SPDX-License-Identifier: GPL-3.0-or-later
// Files of EULUMDAT, one value in each line.
#pragma once

#include "photometry/photometric_file.h"

#include <string>
#include <string_view>

namespace candelabra {

/// Reads a file of EULUMDAT. Intensities are those of the chosen set of lamps; the plane C0 is
/// horizontal angle 0. Returns an error as a sentence, or an empty string.
std::string read_ldt(std::string_view bytes, const PhotometricChoice&, PhotometricFile&);

}  // namespace candelabra
