// SPDX-License-Identifier: GPL-3.0-or-later
// meter blocks. Called by the reader of scenes.
#pragma once

#include "meter/meter.h"
#include "reading/binder.h"

namespace candelabra {

/// Applies the block to the last argument. Returns false, after a diagnostic, if it was wrong.
bool read_meter(Binder&, const Element& block, Meter&);

}  // namespace candelabra
