// SPDX-License-Identifier: GPL-3.0-or-later
// The colours that patterns have when a scene gives none: POV-Ray 3.7's. Called by the readers of
// pigments.
#pragma once

#include "pattern/pattern.h"
#include "surface/colour_map.h"

namespace candelabra {

/// Never empty. For a pattern that takes a list, the colours of the list, with their places as
/// values.
ColourMap default_map(const Pattern&);

}  // namespace candelabra
