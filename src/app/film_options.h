// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of the options that change the camera's film. The table of options names these
// functions; more of the kind are in app/option_store.h.
#pragma once

#include "app/option_store.h"

namespace candelabra {

namespace store {

void film(Options&, const Given&, Diagnostics&);
void exposure(Options&, const Given&, Diagnostics&);
void white_balance(Options&, const Given&, Diagnostics&);
void response(Options&, const Given&, Diagnostics&);
void pixel_filter(Options&, const Given&, Diagnostics&);
void smooth_edges(Options&, const Given&, Diagnostics&);
void glare(Options&, const Given&, Diagnostics&);
void vignette(Options&, const Given&, Diagnostics&);
void grain(Options&, const Given&, Diagnostics&);

}  // namespace store

}  // namespace candelabra
