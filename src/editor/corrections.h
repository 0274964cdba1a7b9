// SPDX-License-Identifier: GPL-3.0-or-later
// What a message takes a wrong word to be, as a change that an editor can make.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

/// What is to stand in place of `marked`, the text that the message points at, if the message asks
/// "did you mean ...?". Nothing where more than one word is marked.
std::optional<std::string> correction(std::string_view message, std::string_view marked);

}  // namespace candelabra
