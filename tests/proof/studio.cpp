// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/studio.h"

#include "render/render.h"
#include "scene/dump.h"
#include "session/session.h"
#include "text/excerpt.h"

#include <utility>

namespace candelabra::proof {

RenderSettings settings_with(const Studio& studio, const std::vector<RunOption>& options) {
    RenderSettings settings;
    settings.width = studio.width;
    settings.height = studio.height;
    settings.threads = 1;
    for (const RunOption& each : options)
        RenderSettings::vocabulary.set(&settings, each.field, each.value);
    return settings;
}

namespace {

SessionSettings session_settings(const Studio& studio, const std::string& text,
                                 const RenderSettings& render) {
    const std::string root = CANDELABRA_SOURCE_DIR;
    SessionSettings session;
    session.source.text = text;
    session.source.name = "scene.pov";
    session.source.standard_library = root + "/stdlib";
    session.source.library = {root + "/tests/conformance/pictures", root + "/stdlib/models",
                              root + "/tests/proof/models", root + "/tests/photometry/files"};
    session.render = render;
    session.instances = studio.instances;
    session.evaluation.limits.steps = 1'000'000;
    session.notes_files = false;
    return session;
}

}  // namespace

/// What is kept of a legal scene.
struct Prepared::Parts {
    RenderSettings settings;
    const Shot shot;
};

Prepared::Prepared(const Studio& studio, const std::string& text,
                   const std::vector<RunOption>& options) {
    const RenderSettings settings = settings_with(studio, options);
    Diagnostics diagnostics;
    Session run(session_settings(studio, text, settings), diagnostics);
    run.read();
    Scene scene = run.evaluate();
    if (!diagnostics.failed())
        parts_.reset(
            new Parts{settings, Shot(run.compile(std::move(scene), Session::Shutter::all_samples),
                                     ShotSettings::of(settings))});
    for (const Diagnostic& each : diagnostics.all())
        if (each.severity == Severity::error) complaint_ += format(each, run.sources(), false);
}

std::optional<std::string> dumped(const Studio& studio, const std::string& text,
                                  const std::vector<RunOption>& options) {
    Diagnostics diagnostics;
    Session run(session_settings(studio, text, settings_with(studio, options)), diagnostics);
    run.read();
    const WrittenFunctions functions;
    const Scene scene = run.evaluate();
    if (diagnostics.failed()) return {};
    return dump(scene);
}

Prepared::~Prepared() = default;

const Shot& Prepared::shot() const { return parts_->shot; }

RenderSettings Prepared::settings(int samples, int seed) const {
    RenderSettings settings = parts_->settings;
    settings.samples = samples;
    settings.seed = seed;
    return settings;
}

Image Prepared::render(int samples, int seed, const Deadline& end) const {
    const auto plan = plan_of(shot(), settings(samples, seed), [&end] { return end.over(); });
    return plan ? rendered(*plan, end) : Image();
}

Image rendered(const RenderPlan& plan, const Deadline& end) {
    RenderHooks hooks;
    hooks.cancelled = [&end] { return end.over(); };
    RenderState state = begin_picture(plan.settings);
    LightLedger ledger;
    return advance(plan, state, ledger, hooks) ? state.film.image() : Image();
}

}  // namespace candelabra::proof
