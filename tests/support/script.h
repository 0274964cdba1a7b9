// SPDX-License-Identifier: GPL-3.0-or-later
// A script evaluated in memory, with everything that was said about it: for the tests of the
// readers of blocks.
#pragma once

#include "bind/evaluate.h"
#include "text/excerpt.h"

#include <map>
#include <string>

namespace candelabra {

struct Script {
    Scene scene;
    std::vector<Diagnostic> said;
    std::string text;  ///< all of `said`, as people see it

    const Object& object(std::size_t i = 0) const { return *scene.objects.at(i); }
    template <class T>
    const T& shape(std::size_t i = 0) const {
        return std::get<T>(std::get<Shape>(object(i).form));
    }
    const Texture& texture(std::size_t i = 0) const { return *object(i).texture; }
    const View& view() const {
        return std::visit([](const auto& camera) -> const View& { return camera; }, scene.camera);
    }
};

/// `files` are what the script may include.
inline Script run(const std::string& script, const std::map<std::string, std::string>& files = {},
                  const EvaluateOptions& options = {}) {
    SourceStore sources;
    Diagnostics diagnostics;
    const Loader loader([&](const std::string& path) -> std::optional<std::string> {
        const auto found = files.find(path);
        return found == files.end() ? std::nullopt : std::optional(found->second);
    });
    Script result;
    result.scene = evaluate(sources, loader, sources.add("main.pov", script), options, diagnostics);
    result.said = diagnostics.all();
    for (const Diagnostic& diagnostic : result.said)
        result.text += format(diagnostic, sources, false);
    return result;
}

/// The one thing that is said about the script: "error out-of-range: message", or "nothing".
inline std::string complaint(const std::string& script) {
    const Script done = run("#version 3.7;\n" + script);
    if (done.said.empty()) return "nothing";
    if (done.said.size() > 1) return "several:\n" + done.text;
    const Diagnostic& only = done.said.front();
    return std::string(only.severity == Severity::error ? "error " : "warning ") +
           std::string(name(only.fault)) + ": " + only.message;
}

/// What #debug says in the script, and behind it the first line of what is said about the script.
inline std::string debugged(const std::string& script) {
    std::string text;
    EvaluateOptions options;
    options.print = [&](std::string_view said) { text += said; };
    const Script done = run(script, {}, options);
    return text + done.text.substr(0, done.text.find('\n'));
}

}  // namespace candelabra
