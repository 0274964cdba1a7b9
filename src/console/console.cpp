// SPDX-License-Identifier: GPL-3.0-or-later
#include "console/console.h"

#include "console/diagnostics_json.h"
#include "text/excerpt.h"

#include <string>

namespace candelabra {

void say(const Console& console, Stream stream, std::string_view text, std::string_view plain) {
    if (console.heard) console.heard(stream, plain);
    if (console.sorted)
        console.sorted(stream, text, plain);
    else
        console.err(text);
}

void say(const Console& console, const Options& options, const Diagnostic& said,
         const SourceStore& sources) {
    if (console.diagnosed) console.diagnosed(said, sources);
    Diagnostic diagnostic = said;
    if (said.fault == Fault::include_not_found && console.library.empty())
        diagnostic.with_note(
            "no standard library was found beside the program; the variable CANDELABRA_STDLIB can "
            "name its folder");
    const Stream stream = diagnostic.severity == Severity::error ? Stream::fatal : Stream::warning;
    const std::string plain = format(diagnostic, sources, false);
    if (!options.diagnostics_as_json)
        return say(console, stream, format(diagnostic, sources, console.coloured), plain);
    if (console.heard) console.heard(stream, plain);
    console.err(to_json(diagnostic, sources));
}

void say_errors(const Console& console, const Options& options, const Diagnostics& diagnostics) {
    for (const Diagnostic& each : diagnostics.all()) say(console, options, each, SourceStore());
}

}  // namespace candelabra
