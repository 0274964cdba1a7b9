// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a scene: no crash, and an end within the limits. No file is read or written.
#include "bind/evaluate.h"
#include "fuzz/target.h"
#include "text/excerpt.h"

using namespace candelabra;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    SourceStore sources;
    const SourceId id = sources.add("input", {reinterpret_cast<const char*>(data), size});
    const Loader loader([](const std::string&) { return std::nullopt; });
    EvaluateOptions options;
    options.limits.steps = 300;
    options.limits.array_elements = 10'000;
    options.limits.call_depth = 100;
    options.limits.nesting = 100;
    // The sanitizer goes over all of a stack.
    options.limits.stack_bytes = std::size_t{1} << 24;
    Diagnostics diagnostics;
    evaluate(sources, loader, id, options, diagnostics);
    for (const Diagnostic& each : diagnostics.all()) format(each, sources, false);
    return 0;
}
