// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/plan.h"

#include "base/unless_ended.h"
#include "render/pilot.h"

#include <algorithm>
#include <variant>

namespace candelabra {

namespace {

/// Whether the number of samples depends on the number of shadow rays.
bool follows_shadow_rays(const Shot& shot, const RenderSettings& settings) {
    return settings.samples <= 0 && settings.noise <= 0 && !shot.view.camera.blurs();
}

/// Returns the number of samples that the noise of the light needs. `rays`: number of shadow rays
/// at each hit, where relevant; `many`: see Pilot::many_rays. `quiet`: there is hardly any noise.
int usual_samples(const World& world, const RenderSettings& settings, int rays, bool many,
                  bool quiet) {
    const int first_for_noise = many ? 4 : 16;
    if (settings.noise > 0)
        return settings.samples > 0 ? std::clamp(settings.samples, 2, first_for_noise)
                                    : first_for_noise;
    if (settings.samples > 0) return settings.samples;
    // With more shadow rays per sample, fewer samples suffice.
    constexpr int least = 4, least_of_many = 2, to_middle = 16, min_in_media = 2;
    if (!settings.antialias) {
        if (!world.facts.left_to_chance || quiet) return 1;
        if (world.facts.differs_by_light)
            return std::max(many ? least_of_many : least, to_middle / rays);
        return world.photon_targets.empty() ? min_in_media : least;
    }
    const int first = std::max(2, (1 << (2 * settings.antialias_depth)) / 8);
    return rays == 1 ? first : std::min(first, std::max(least, first / rays));
}

/// Returns the number of samples that see all moments, and all that a pixel of the camera sees.
int least_samples(const Shot& shot, const RenderSettings& settings) {
    if (settings.samples > 0 || settings.noise > 0) return 0;
    const int moments = static_cast<int>(shot.moments());
    return std::max(moments, shot.view.camera.mesh ? shot.view.camera.mesh->rays_per_pixel() : 1);
}

}  // namespace

RenderPlan plan_of(const Shot& shot, const RenderSettings& settings) {
    return *plan_of(shot, settings, {});
}

std::optional<RenderPlan> plan_of(const Shot& shot, const RenderSettings& settings,
                                  const std::function<bool()>& cancelled) {
    const auto sent = unless_ended(
        cancelled, [&] { return SentLight::of(shot, settings.seed, settings.threads); });
    return sent ? plan_of(shot, settings, *sent, cancelled) : std::nullopt;
}

RenderPlan plan_without_trials(const Shot& shot, const RenderSettings& settings, SentLight sent) {
    const auto* traced = std::get_if<PathTraced>(&shot.world->rules.settings.integrator);
    if (traced && !traced->reflected_luminaires) sent.reflected = nullptr;
    RenderSettings simple = settings;
    simple.shadow_rays = 1;
    RenderPlan plan = *plan_of(shot, simple, sent, {});
    plan.settings = settings;
    return plan;
}

std::optional<RenderPlan> plan_of(const Shot& shot, const RenderSettings& settings,
                                  const SentLight& sent, const std::function<bool()>& cancelled) {
    const World& world = *shot.world;
    Pilot tried = pilot(shot, settings, sent, cancelled);
    if (cancelled && cancelled()) return {};
    SentLight used = sent;
    if (tried.by_paths) used.reflected = nullptr;
    const int shared = follows_shadow_rays(shot, settings) ? tried.shadow_rays.usual : 1;
    const bool quiet = tried.quiet && !world.lights.sources.empty() && world.sky.light.empty();
    const bool single = quiet && !settings.antialias && follows_shadow_rays(shot, settings);
    if (single && settings.shadow_rays == 0) tried.shadow_rays = {};
    const SampleRule rule =
        choose_rule({settings, shot.view.camera, shot.view.film, world.rules.settings.assumed_gamma,
                     world.facts.left_to_chance, quiet});
    const FirstSamples wanted{usual_samples(world, settings, shared, tried.many_rays, single),
                              least_samples(shot, settings)};
    const int samples = std::visit([&](const auto& each) { return each.first(wanted); }, rule);
    return RenderPlan{shot, settings, tried.shadow_rays, used, static_cast<std::uint32_t>(samples),
                      rule};
}

}  // namespace candelabra
