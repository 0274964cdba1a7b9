// SPDX-License-Identifier: GPL-3.0-or-later
// Decimal numbers beyond the range of a double.
#pragma once

#include <string_view>

namespace candelabra {

/// Whether a decimal number without a sign, which std::from_chars found to be out of range, is too
/// small for a double. False: it is too large.
bool underflows(std::string_view number);

}  // namespace candelabra
