// SPDX-License-Identifier: GPL-3.0-or-later
// The bounding boxes that min_extent and max_extent tell: POV-Ray's own, which are looser than
// bounds() for some shapes and for what is turned. Scenes compute with them.
#pragma once

#include "scene/scene.h"

/// POV-Ray's number for no end.
inline constexpr double no_end = 1e10;

/// The box of the object in its own space, from -no_end to no_end where it has no end.
Box extent(const Object&);
/// The same before it is moved and confined.
Box own_extent(const Object&);
