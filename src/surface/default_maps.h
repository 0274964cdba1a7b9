// SPDX-License-Identifier: GPL-3.0-or-later
// Default colours of patterns, for scenes that give none: POV-Ray 3.7's. Used by the readers of
// pigments.
#pragma once

#include "pattern/pattern.h"
#include "surface/colour_map.h"

namespace candelabra {

/// Never empty. For a pattern that takes a list, the list's colours, with their indices as values.
ColourMap default_map(const Pattern&);

}  // namespace candelabra
