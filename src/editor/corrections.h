// SPDX-License-Identifier: GPL-3.0-or-later
// Turns a "did you mean" in a message into a change that an editor can make.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

/// Returns the replacement for `marked`, the text that the message points at, if the message asks
/// "did you mean ...?". Returns nothing if more than one word is marked.
std::optional<std::string> correction(std::string_view message, std::string_view marked);

}  // namespace candelabra
