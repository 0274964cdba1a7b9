// SPDX-License-Identifier: GPL-3.0-or-later
// Handlers of the options that limit the resources of a scene. The table of options refers to these
// functions; app/option_store.h declares more of them.
#pragma once

#include "app/option_store.h"

namespace candelabra {

namespace store {

void limit_steps(Options&, const Given&, Diagnostics&);
void limit_depth(Options&, const Given&, Diagnostics&);
void limit_nesting(Options&, const Given&, Diagnostics&);
void limit_objects(Options&, const Given&, Diagnostics&);
void limit_includes(Options&, const Given&, Diagnostics&);
void limit_elements(Options&, const Given&, Diagnostics&);
void limit_memory(Options&, const Given&, Diagnostics&);
void limit_written(Options&, const Given&, Diagnostics&);
void limit_files(Options&, const Given&, Diagnostics&);
void limit_said(Options&, const Given&, Diagnostics&);
void limit_text(Options&, const Given&, Diagnostics&);
void limit_function(Options&, const Given&, Diagnostics&);
void limit_work(Options&, const Given&, Diagnostics&);

}  // namespace store

}  // namespace candelabra
