// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console.h"

#include "app/diagnostics_json.h"
#include "text/excerpt.h"

void say_errors(const Console& console, const Options& options, const Diagnostics& diagnostics) {
    for (const Diagnostic& each : diagnostics.all())
        console.err(options.diagnostics_as_json ? to_json(each, SourceStore())
                                                : format(each, SourceStore(), console.coloured));
}
