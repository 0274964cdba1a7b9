// SPDX-License-Identifier: GPL-3.0-or-later
// Decimal numbers in texts, also those beyond the range of a double.
#pragma once

#include <optional>
#include <string_view>

namespace candelabra {

/// Whether a decimal number without a sign, which std::from_chars found to be out of range, is too
/// small for a double. False: it is too large.
bool underflows(std::string_view number);

/// Returns the finite number that fills the whole text, which may begin with `-`; nothing for other
/// texts, among them those with a `+` or blanks.
std::optional<double> finite_number(std::string_view text);

}  // namespace candelabra
