// SPDX-License-Identifier: GPL-3.0-or-later
// The whole way from any bytes to a picture of 16x12 pixels, which is denoised and, where the scene
// has a film, developed: no crash, and no pixel that is not a number. Rendering is stopped after a
// while, since nothing limits how long a picture may take.
#include "bind/evaluate.h"
#include "film/develop.h"
#include "fuzz/target.h"
#include "output/film_images.h"
#include "output/layers.h"
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

void must_be_numbers(const Image& image) {
    for (const Rgb& pixel : image.pixels)
        for (int c = 0; c < 3; ++c)
            if (std::isnan(pixel[c])) std::abort();
}

/// The pictures that the program makes of a film.
void finish(const Film& film, const FilmFiles& files) {
    must_be_numbers(film.image());
    must_be_numbers(denoised_film(film, files).light);
    if (!files.film.on) return;
    const Image shown = develop(negative_of(film, files), files.film, files.threads);
    for (const Rgb& pixel : shown.pixels)
        for (int c = 0; c < 3; ++c)
            if (!(pixel[c] >= 0 && pixel[c] <= 1)) std::abort();
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
    review(scene, *survey(scene, diagnostics), diagnostics);
    const SharedWorld world = compile(scene, how, diagnostics);
    if (diagnostics.failed()) return 0;
    RenderSettings settings;
    settings.width = 16;
    settings.height = 12;
    settings.samples = 2;
    settings.threads = 1;
    const Shot shot(world, ShotSettings::of(settings));
    FilmFiles files;
    files.film = shot.view.film;
    files.denoise = true;
    const RenderPlan plan = plan_of(shot, settings);
    const auto begun = std::chrono::steady_clock::now();
    RenderHooks hooks;
    hooks.aovs = files.aovs();
    hooks.cancelled = [&] {
        return std::chrono::steady_clock::now() - begun > std::chrono::milliseconds(500);
    };
    RenderState state = begin_picture(plan.settings, hooks.aovs.count(*shot.world));
    LightLedger ledger;
    advance(plan, state, ledger, hooks);
    finish(state.film, files);
    return 0;
}
