// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of one argument (sin, sqrt, ...) on intervals with slopes. Called by enclose() for
// Operation::apply.
#pragma once

#include "formula/enclosure.h"

namespace candelabra {

/// The function of apply_function() with that number. Arguments for which there is no value do not
/// count.
Enclosure enclosed_function(std::uint16_t number, const Enclosure&);

}  // namespace candelabra
