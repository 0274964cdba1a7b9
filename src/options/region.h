// SPDX-License-Identifier: GPL-3.0-or-later
// The rows and columns of the picture that are rendered, by POV-Ray's rules for +SR, +ER, +SC, +EC.
#pragma once

#include "film/picture_shard.h"
#include "options/options.h"

namespace candelabra {

/// Returns the region to render. In the options, rows and columns count from 1, and the last ones
/// are included; values below 1 are fractions of the picture. Clipped to the picture; may be empty.
Region region_of(const Options&);

}  // namespace candelabra
