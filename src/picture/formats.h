// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses who reads and writes a picture file: libpng, or the library of all formats, which is
// opened when it is first needed.
#pragma once

#include "oiio/formats.h"
#include "text/diagnostic.h"
#include "text/loader.h"

#include <optional>
#include <string>

namespace candelabra {

/// More have only files that are damaged.
inline constexpr std::int64_t max_pixels = std::int64_t{1} << 28;

/// The entry points; null, with a diagnostic at the span, when the library cannot be opened.
const Formats* picture_formats(Diagnostics&, Span asked_at = {});

/// The picture as its file has it; a Targa file is known by its name. Nothing, with a diagnostic at
/// the span, when it cannot be read, or is larger than any picture that is not damaged.
std::optional<StoredPicture> read_stored(const Found&, Diagnostics&, Span asked_at);

/// The bytes of a file that holds the picture. Nothing, with a diagnostic, when it cannot be made.
std::optional<std::string> write_stored(const RawPicture&, Diagnostics&);

/// Whether POV-Ray keeps the picture's greys in bytes, of a brightness that is not rounded.
bool keeps_whole_brightness(const StoredPicture&);
/// Such a grey.
float whole_brightness(float value);

}  // namespace candelabra
