// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of one argument (sin, sqrt, ...) on intervals with slopes. Called by enclose() for
// Operation::apply.
#pragma once

#include "formula/enclosure.h"

namespace candelabra {

/// Encloses the function of apply_function() with that number. Arguments outside its domain are
/// ignored.
Enclosure enclosed_function(std::uint16_t number, const Enclosure&);

}  // namespace candelabra
