// SPDX-License-Identifier: GPL-3.0-or-later
// A text parsed to a tree, with all that it needs, for tests.
#pragma once

#include "syntax/dump.h"
#include "syntax/parser.h"
#include "text/excerpt.h"

#include <string>

namespace candelabra {

struct Parsed {
    explicit Parsed(const std::string& text)
        : source(sources.add("test.pov", text)), tree(parse(source, sources, names, diagnostics)) {}

    /// The messages, a line each: "1:5 error: ...".
    std::string messages() const {
        std::string result;
        for (const Diagnostic& d : diagnostics.all()) {
            const Place place = sources.place(d.span.source, d.span.first);
            result += std::to_string(place.line) + ":" + std::to_string(place.column) +
                      (d.severity == Severity::error ? " error: " : " warning: ") + d.message +
                      "\n";
        }
        return result;
    }
    std::string dumped() const { return dump(tree, names); }

    SourceStore sources;
    Names names;
    Diagnostics diagnostics;
    SourceId source;
    Tree tree;
};

}  // namespace candelabra
