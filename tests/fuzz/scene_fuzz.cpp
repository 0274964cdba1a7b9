// SPDX-License-Identifier: GPL-3.0-or-later
// The whole way from any bytes to a picture of 16x12 pixels: no crash, and no pixel that is not a
// number. Rendering is stopped after a while, since nothing limits how long a picture may take.
#include "bind/evaluate.h"
#include "fuzz/target.h"
#include "render/render.h"
#include "world/compile.h"
#include "world/review.h"

#include <chrono>
#include <cmath>
#include <cstdlib>

using namespace candelabra;

namespace {

Limits small_limits() {
    Limits limits;
    limits.steps = 300;
    limits.work = 300'000;
    limits.objects = 300;
    limits.array_elements = 1'000;
    limits.call_depth = 100;
    limits.nesting = 100;
    limits.stack_bytes = std::size_t{1} << 24;
    return limits;
}

void check(const Image& image) {
    for (const Vec3& pixel : image.pixels)
        for (int c = 0; c < 3; ++c)
            if (std::isnan(pixel[c])) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    SourceStore sources;
    const SourceId id = sources.add("input", {reinterpret_cast<const char*>(data), size});
    const Loader loader([](const std::string&) { return std::nullopt; });
    EvaluateOptions options;
    options.limits = small_limits();
    Diagnostics diagnostics;
    const Scene scene = evaluate(sources, loader, id, options, diagnostics);
    if (diagnostics.failed()) return 0;
    CompileOptions how;
    how.threads = 1;
    how.width = 16;
    how.height = 12;
    review(scene, survey(scene, diagnostics), diagnostics);
    const World world = compile(scene, how, diagnostics);
    if (diagnostics.failed()) return 0;
    RenderSettings settings;
    settings.width = how.width;
    settings.height = how.height;
    settings.samples = 1;
    settings.threads = 1;
    const auto begun = std::chrono::steady_clock::now();
    RenderHooks hooks;
    hooks.cancelled = [&] {
        return std::chrono::steady_clock::now() - begun > std::chrono::milliseconds(500);
    };
    check(render(world, settings, hooks).image);
    return 0;
}
