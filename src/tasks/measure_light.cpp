// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measure_light.h"

#include "output/measurement.h"
#include "tasks/measuring.h"

#include <optional>
#include <utility>
#include <vector>

namespace candelabra {

int measure_light(SceneSteps& steps) {
    std::optional<Scene> scene = steps.valid_scene();
    if (!scene) return exit_status::scene;
    const std::vector<Meter> meters = scene->meters;
    const SharedWorld world =
        steps.reviewed_world(std::move(*scene), Session::Shutter::all_samples);
    if (!world) return exit_status::scene;
    const Shot shot = steps.shot(world);
    const LightUnits units = world->rules.settings.light_units();
    review_meters(*world, meters, steps.diagnostics());
    review_moments(shot, steps.options(), steps.diagnostics());
    if (steps.say_diagnostics()) return exit_status::scene;
    bool stopped = false;
    const MeasureSettings settings = measure_settings(steps, stopped);
    const std::vector<MeterReading> readings = measure(shot, meters, settings);
    const MeasuredScene measured{meters, readings, units, settings.seed};
    if (settings.samples <= 0) review_readings(measured, settings.goal, steps.diagnostics());
    review_places(measured, steps.diagnostics());
    const bool json = measures_as_json(steps.options());
    return write_measured(steps, json ? readings_as_json(measured) : readings_as_csv(measured),
                          readings_as_text(measured), stopped);
}

}  // namespace candelabra
