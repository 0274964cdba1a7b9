// SPDX-License-Identifier: GPL-3.0-or-later
// The value of a string, from the text between its quotes.
#pragma once

#include "text/diagnostic.h"

#include <string>
#include <string_view>

namespace candelabra {

/// Returns the text with escapes replaced and each line end made one LF. `offset`: of its first
/// byte in the source. An unknown escape is reported and kept unchanged.
std::string unescaped(std::string_view raw, SourceId source, std::uint32_t offset, Diagnostics&);

}  // namespace candelabra
