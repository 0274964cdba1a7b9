// SPDX-License-Identifier: GPL-3.0-or-later
// Writes Radiance's pictures (radsite.lbl.gov/radiance/refer/filefmts.pdf): three bytes and an
// exponent for each pixel, with runs of equal bytes shortened.
#pragma once

#include "oiio/formats.h"

#include <string>

namespace candelabra {

/// Encodes a picture of three floats for each pixel, none of them negative. Returns an error
/// message, or an empty string.
std::string write_hdr(const RawPicture&, std::string& bytes);

}  // namespace candelabra
