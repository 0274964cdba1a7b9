// SPDX-License-Identifier: GPL-3.0-or-later
// finish and interior blocks. Called by the readers of textures, of objects and of #declare.
#pragma once

#include "evaluate/binder.h"

/// Both change the last argument to what the block makes of it. False: the block was wrong, and has
/// been reported.
bool read_finish(Binder&, const Element& block, Finish&);
bool read_interior(Binder&, const Element& block, Interior&);
