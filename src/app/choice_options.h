// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of the options that choose one of several items of the vocabulary by its name. The
// table of options names these functions; more of the kind are in app/option_store.h.
#pragma once

#include "app/option_store.h"

namespace candelabra {

namespace store {

void sampler(Options&, const Given&, Diagnostics&);
void integrator(Options&, const Given&, Diagnostics&);
void index(Options&, const Given&, Diagnostics&);
void luminaires(Options&, const Given&, Diagnostics&);

}  // namespace store

}  // namespace candelabra
