// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks of surroundings: background, sky_sphere, fog and rainbow. Called by the
// reader of scenes and of #declare.
#pragma once

#include "reading/binder.h"

namespace candelabra {

/// These functions apply the block to the last argument. They return false, after a diagnostic, if
/// the block was wrong.
bool read_sky_sphere(Binder&, const Element& block, SkySphere&);
bool read_fog(Binder&, const Element& block, Fog&);
bool read_rainbow(Binder&, const Element& block, Rainbow&);

/// Applies the block to the last argument, which a wrong block leaves unchanged.
void read_background(Binder&, const Element& block, Background&);

}  // namespace candelabra
