// SPDX-License-Identifier: GPL-3.0-or-later
// Reads `meter { ... }`, and the file of a road's reflection that it names. Called by the table of
// blocks.
#pragma once

#include "meter/meter.h"
#include "reading/binder.h"

namespace candelabra {

/// Returns false, after a diagnostic, if the block was wrong.
bool read_meter(Binder&, const Element&, Meter&);

}  // namespace candelabra
