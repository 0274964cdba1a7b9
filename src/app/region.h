// SPDX-License-Identifier: GPL-3.0-or-later
// Which rows and columns of the picture are rendered, by POV-Ray's rules for +SR, +ER, +SC, +EC.
#pragma once

#include "app/options.h"
#include "film/picture_shard.h"

namespace candelabra {

/// Rows and columns count from 1, the last ones included; what is below 1 is a fraction of the
/// picture. Clipped to the picture; may be empty.
Region region_of(const Options&);

}  // namespace candelabra
