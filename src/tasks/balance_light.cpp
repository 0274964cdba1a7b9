// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/balance_light.h"

#include "output/balance_report.h"
#include "tasks/measuring.h"

#include <optional>
#include <utility>
#include <variant>

namespace candelabra {

int balance_light(SceneSteps& steps) {
    std::optional<Scene> scene = steps.valid_scene();
    if (!scene) return exit_status::scene;
    BalanceSettings settings;
    settings.up = std::visit([](const View& view) { return view.sky; }, scene->camera);
    const SharedWorld world =
        steps.reviewed_world(std::move(*scene), Session::Shutter::all_samples);
    if (!world) return exit_status::scene;
    const Shot shot = steps.shot(world);
    review_balance(*world, steps.diagnostics());
    review_moments(shot, steps.options(), steps.diagnostics());
    if (steps.say_diagnostics()) return exit_status::scene;
    settings.seed = steps.options().render.seed;
    settings.threads = steps.options().render.threads;
    settings.samples = steps.options().render.samples;
    bool stopped = false;
    settings.ended = ends_measuring(steps, stopped);
    const LightBalance balance = balance_of_light(shot, settings);
    const BalancedScene balanced{*world, balance, steps.sources(), settings.seed};
    const bool json = measures_as_json(steps.options());
    return write_measured(steps, json ? balance_as_json(balanced) : balance_as_csv(balanced),
                          balance_as_text(balanced), stopped);
}

}  // namespace candelabra
