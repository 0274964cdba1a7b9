// SPDX-License-Identifier: GPL-3.0-or-later
// Handlers of the options that select an item of the vocabulary by its name. The table of options
// refers to these functions; options/option_store.h declares more of them.
#pragma once

#include "options/option_store.h"

namespace candelabra {

namespace store {

void sampler(Options&, const Given&, Diagnostics&);
void integrator(Options&, const Given&, Diagnostics&);
void index(Options&, const Given&, Diagnostics&);
void luminaires(Options&, const Given&, Diagnostics&);

}  // namespace store

}  // namespace candelabra
