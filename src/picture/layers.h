// SPDX-License-Identifier: GPL-3.0-or-later
// OpenEXR files with named planes: pictures with more than colour channels, and the states of
// unfinished pictures. The planes' values are preserved bit by bit.
#pragma once

#include "oiio/formats.h"
#include "text/diagnostic.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace candelabra {

/// Returns the bytes of the file; nothing, with a diagnostic, if it cannot be made.
std::optional<std::string> encode(const LayeredPicture&, Diagnostics&);

/// Reads all planes, and the texts with the given names ("" for those that the file lacks). Returns
/// nothing, with a diagnostic, if the file is not an OpenEXR file or is damaged.
std::optional<LayeredPicture> read_layers(const std::string& path,
                                          std::span<const std::string_view> texts, Diagnostics&);
/// The same for the bytes of a file, whose path is for messages.
std::optional<LayeredPicture> read_layers(std::string_view bytes, const std::string& path,
                                          std::span<const std::string_view> texts, Diagnostics&);
/// Returns the bytes of a file; nothing, with a diagnostic, if it cannot be read.
std::optional<std::string> bytes_of_layers(const std::string& path, Diagnostics&);

}  // namespace candelabra
