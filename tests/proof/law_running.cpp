// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/laws.h"
#include "render/render.h"
#include "world/world.h"

#include <algorithm>

namespace candelabra::proof {

namespace {

std::vector<Term> seen_by(const Script& script, View view) {
    std::vector<Term> terms = picture(script);
    terms.front().view = std::move(view);
    return terms;
}

Image with_threads(const Prepared& scene, int samples, int seed, const Deadline&) {
    RenderSettings settings = scene.settings(samples, seed);
    settings.threads = 3;
    return render(scene.shot(), settings).image;
}

/// A picture that was stopped after every few samples and went on.
Image interrupted(const Prepared& scene, int samples, int seed, const Deadline& end) {
    const RenderSettings settings = scene.settings(samples, seed);
    RenderState state = begin_picture(settings);
    LightLedger rays;
    for (int patience = 1; !end.over(); patience += 2) {
        int questions = 0;
        RenderHooks hooks;
        hooks.cancelled = [&] { return ++questions > patience; };
        RenderState copy = state;
        if (advance(plan_of(scene.shot(), settings), copy, rays, hooks)) return copy.film.image();
        state = copy;
    }
    return {};
}

/// A picture of which each half was made apart.
Image in_halves(const Prepared& scene, int samples, int seed, const Deadline&) {
    const RenderSettings settings = scene.settings(samples, seed);
    LightLedger rays;
    const auto part = [&](Region region) {
        RenderState state = begin_picture(settings);
        state.shard.region = region;
        advance(plan_of(scene.shot(), settings), state, rays);
        return state.film;
    };
    const int middle = settings.height / 2;
    Film whole = part({0, 0, settings.width, middle});
    const Film other = part({0, middle, settings.width, settings.height});
    for (std::size_t i = 0; i < whole.pixels().size(); ++i) whole.add(i, other);
    return whole.image();
}

}  // namespace

Claims other_runs(const Script& script, Dice&) {
    return {same_bytes("three threads", picture(script), seen_by(script, with_threads)),
            same_bytes("interrupted", picture(script), seen_by(script, interrupted)),
            same_bytes("in halves", picture(script), seen_by(script, in_halves))};
}

}  // namespace candelabra::proof
