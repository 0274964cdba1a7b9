// SPDX-License-Identifier: GPL-3.0-or-later
// The output of a script by #debug, for tests of the language without any items. Blocks are walked
// and ignored, and functions of objects have no objects.
#pragma once

#include "interpret/evaluator.h"
#include "objects/object_functions.h"
#include "objects/solid_queries.h"

#include <map>
#include <string>
#include <vector>

namespace candelabra {

struct Said {
    std::string printed;
    std::string messages;  ///< a line each: "error: ...", with the frames in parentheses
    std::string elements;  ///< of the scene: "word a, value, block sphere"
};

/// Macros to print numbers: P(number), V(count, vector).
inline const std::string prelude =
    "#version 3.7;\n"
    "#macro P(vv) #debug concat(str(vv, 0, 6), \" \") #end\n"
    "#macro V(nn, vv) #debug concat(\"<\", vstr(nn, vv, \",\", 0, 4), \"> \") #end\n";

inline Said said(const std::string& script, const std::map<std::string, std::string>& files = {},
                 const Limits& limits = {}) {
    SourceStore sources;
    Names names;
    Diagnostics diagnostics;
    const Loader loader([&](const std::string& path) -> std::optional<std::string> {
        const auto found = files.find(path);
        return found == files.end() ? std::nullopt : std::optional(found->second);
    });
    Evaluator evaluator(sources, loader, names, diagnostics);
    SolidQueries objects;
    evaluator.add_functions(object_functions(), objects);
    evaluator.set_limits(limits);
    evaluator.declare("Outside", 42.0);
    Said result;
    ElementHandlers handlers;
    handlers.top = [&](const Element& element) {
        constexpr std::string_view kinds[] = {"value", "word", "block", "entry", "braces", "list"};
        result.elements += (result.elements.empty() ? "" : ", ") +
                           std::string(kinds[static_cast<std::size_t>(element.kind)]);
        if (element.word != no_name)
            result.elements += " " + std::string(names.spelling(element.word));
        if (element.body.tree) evaluator.walk(element.body, [](const Element&) {});
    };
    handlers.value = [&](std::span<const Element> blocks) {
        for (const Element& block : blocks) evaluator.walk(block.body, [](const Element&) {});
        return Value(Handle<Finish>());
    };
    handlers.set_default = [](const Element&) {};
    handlers.print = [&](std::string_view text) { result.printed += text; };
    evaluator.set_handlers(handlers);
    evaluator.run(sources.add("main.pov", script));
    for (const Diagnostic& d : diagnostics.all()) {
        result.messages += (d.severity == Severity::error ? "error: " : "warning: ") + d.message;
        if (!d.frames.empty() && d.frames.size() < 4)
            for (const Frame& frame : d.frames) result.messages += " (" + frame.name + ")";
        result.messages += "\n";
    }
    return result;
}

/// The output of a script after the prelude, or its messages if it has any.
inline std::string printed(const std::string& script) {
    const Said result = said(prelude + script);
    if (!result.messages.empty()) return result.messages;
    return result.printed.substr(0, result.printed.find_last_not_of(' ') + 1);
}

}  // namespace candelabra
