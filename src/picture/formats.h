// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses the reader or writer of a picture file: those of png/ and raster/, or the library of all
// formats, which is loaded when it is first needed.
#pragma once

#include "oiio/formats.h"
#include "text/diagnostic.h"
#include "text/loader.h"

#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

/// Pictures with more pixels are taken to be damaged.
inline constexpr std::int64_t max_pixels = std::int64_t{1} << 28;

/// Whether files with this extension are written without the library.
bool writes_itself(std::string_view extension);

/// Returns the library's entry points; null, with a diagnostic at the span, if it cannot be loaded.
const Formats* picture_formats(Diagnostics&, Span asked_at = {});

/// Returns the picture as its file stores it. A Targa file is recognised by its name. Returns
/// nothing, with a diagnostic at the span, if the file cannot be read or has more than
/// `max_pixels`.
std::optional<StoredPicture> read_stored(const Found&, Diagnostics&, Span asked_at);

/// Encodes the picture as a file. Returns nothing, with a diagnostic, if that is impossible.
std::optional<std::string> write_stored(const RawPicture&, Diagnostics&);

/// Whether POV-Ray stores the picture's greys as bytes of their truncated brightness.
bool keeps_whole_brightness(const StoredPicture&);
/// Returns the brightness of a grey in 0..1, truncated to a multiple of 1/255.
float whole_brightness(float value);

}  // namespace candelabra
