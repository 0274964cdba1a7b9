// SPDX-License-Identifier: GPL-3.0-or-later
// background, sky_sphere, fog and rainbow blocks. Called by the reader of scenes and of #declare.
#pragma once

#include "bind/binder.h"

namespace candelabra {

/// All change the last argument to what the block makes of it. False: the block was wrong, and has
/// been reported.
bool read_sky_sphere(Binder&, const Element& block, SkySphere&);
bool read_fog(Binder&, const Element& block, Fog&);
bool read_rainbow(Binder&, const Element& block, Rainbow&);

/// The same, but a wrong block changes nothing.
void read_background(Binder&, const Element& block, Background&);

}  // namespace candelabra
