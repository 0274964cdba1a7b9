// SPDX-License-Identifier: GPL-3.0-or-later
// Handlers of the options for long work: states, shards, limits, parts of a picture. The table of
// options refers to these functions; app/option_store.h declares more of them.
#pragma once

#include "app/option_store.h"

namespace candelabra {

namespace store {

void layers(Options&, const Given&, Diagnostics&);
void alpha(Options&, const Given&, Diagnostics&);
void denoise(Options&, const Given&, Diagnostics&);
void grey(Options&, const Given&, Diagnostics&);
void time(Options&, const Given&, Diagnostics&);
void start_row(Options&, const Given&, Diagnostics&);
void end_row(Options&, const Given&, Diagnostics&);
void start_column(Options&, const Given&, Diagnostics&);
void end_column(Options&, const Given&, Diagnostics&);
void frames(Options&, const Given&, Diagnostics&);
void go_on(Options&, const Given&, Diagnostics&);
void checkpoint(Options&, const Given&, Diagnostics&);
void keep_state(Options&, const Given&, Diagnostics&);
void shard(Options&, const Given&, Diagnostics&);
void shard_by(Options&, const Given&, Diagnostics&);
void preview(Options&, const Given&, Diagnostics&);
void depfile(Options&, const Given&, Diagnostics&);
void progress(Options&, const Given&, Diagnostics&);
void memory(Options&, const Given&, Diagnostics&);
void sandbox(Options&, const Given&, Diagnostics&);

}  // namespace store

}  // namespace candelabra
