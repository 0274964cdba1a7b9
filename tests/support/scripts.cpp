// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/scripts.h"

#include "bind/evaluate.h"
#include "text/excerpt.h"
#include "text/message.h"
#include "world/compile.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace candelabra {

namespace {

const std::string root = CANDELABRA_SOURCE_DIR;

Scene checked(Evaluated result) {
    if (result.failed) throw std::runtime_error(result.diagnostics);
    return std::move(result.scene);
}

Evaluated evaluate_text(const std::string& name, const std::string& text,
                        const Declares& declares) {
    SourceStore sources;
    Diagnostics diagnostics;
    Loader loader(
        disk_reader(), message(root, "/", directory_of(name)),
        {root, root + "/stdlib", root + "/stdlib/models", root + "/tests/conformance/pictures"});
    loader.set_standard_library(root + "/stdlib");
    Evaluated result;
    EvaluateOptions options;
    options.declares = declares;
    options.print = [&](std::string_view said) { result.printed += said; };
    const SourceId main = sources.add(name, text);
    result.scene = evaluate(sources, loader, main, options, diagnostics);
    for (const Diagnostic& d : diagnostics.all()) result.diagnostics += format(d, sources, false);
    result.failed = diagnostics.failed();
    return result;
}

}  // namespace

Evaluated evaluated(const std::string& script, const Declares& declares) {
    return evaluate_text("script.pov", script, declares);
}

Scene scene_of(const std::string& script) { return checked(evaluated(script)); }

SharedWorld world_of(const std::string& script, const std::optional<RayIndex>& index) {
    Diagnostics diagnostics;
    CompileOptions options;
    options.index = index;
    return compile(scene_of(script), options, diagnostics);
}

SharedWorld world_of(const Scene& scene, const LightSampler& sampler) {
    Diagnostics diagnostics;
    CompileOptions options;
    options.light_sampler = sampler;
    return compile(scene, options, diagnostics);
}

Shot shot_of(const std::string& script) { return Shot(world_of(script)); }

Scene scene_of_file(const std::string& path, const Declares& declares) {
    std::ifstream file(root + "/" + path);
    if (!file) throw std::runtime_error("cannot read " + path);
    std::ostringstream text;
    text << file.rdbuf();
    return checked(evaluate_text(path, text.str(), declares));
}

SharedWorld world_of_file(const std::string& path, const Declares& declares,
                          const std::optional<LightSampler>& sampler) {
    Diagnostics diagnostics;
    CompileOptions options;
    options.light_sampler = sampler;
    return compile(scene_of_file(path, declares), options, diagnostics);
}

Shot shot_of_file(const std::string& path, const Declares& declares,
                  const std::optional<LightSampler>& sampler, int size) {
    return square_shot(world_of_file(path, declares, sampler), size);
}

Shot square_shot(SharedWorld world, int size) {
    return Shot(std::move(world), {.width = size, .height = size});
}

}  // namespace candelabra
