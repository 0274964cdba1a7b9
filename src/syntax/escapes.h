// SPDX-License-Identifier: GPL-3.0-or-later
// What is between the quotes of a string, as the string that it means.
#pragma once

#include "text/diagnostic.h"

#include <string>
#include <string_view>

namespace candelabra {

/// Escapes replaced, line ends made one LF. `offset`: of the first byte in its source. An unknown
/// escape is reported and stays as it is.
std::string unescaped(std::string_view raw, SourceId source, std::uint32_t offset, Diagnostics&);

}  // namespace candelabra
