// SPDX-License-Identifier: GPL-3.0-or-later
// OpenEXR files with named planes: pictures with more than colours, and the states of pictures that
// are not finished. The planes' values are kept bit by bit.
#pragma once

#include "oiio/formats.h"
#include "text/diagnostic.h"

#include <optional>
#include <span>
#include <string>

namespace candelabra {

/// The bytes of the file; nothing, with a diagnostic, when it cannot be made.
std::optional<std::string> encode(const LayeredPicture&, Diagnostics&);

/// All planes, and the texts with these names ("" where the file has none). Nothing, with a
/// diagnostic, when the file is no OpenEXR file, or damaged.
std::optional<LayeredPicture> read_layers(const std::string& path,
                                          std::span<const std::string_view> texts, Diagnostics&);

}  // namespace candelabra
