// SPDX-License-Identifier: GPL-3.0-or-later
// PNG files by libpng, which is there at each start: most pictures are PNG files, and to open the
// library of all formats takes longer than many pictures take to make. Called by picture/ instead
// of that library; results are the same.
#pragma once

#include "oiio/formats.h"

namespace candelabra {

/// Whether the bytes are the beginning of a PNG file.
bool is_png(std::string_view bytes);

/// Reads the bytes of a file. A picture of more than `max_pixels` is refused. Returns what went
/// wrong, or an empty string.
std::string read_png(std::string_view bytes, std::int64_t max_pixels, StoredPicture&);

/// Makes the bytes of a file of 8 or 16 bits a channel, which says that it holds sRGB. Returns what
/// went wrong, or an empty string.
std::string write_png(const RawPicture&, std::string& bytes);

}  // namespace candelabra
