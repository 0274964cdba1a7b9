// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/scene_run.h"

#include "base/deep_stack.h"
#include "tasks/balance_light.h"
#include "tasks/check_scene.h"
#include "tasks/dump_stage.h"
#include "tasks/export_mesh.h"
#include "tasks/measure_light.h"
#include "tasks/pick_pixel.h"
#include "tasks/render_picture.h"
#include "tasks/show_preview.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace candelabra {

namespace {

/// How a task over a scene is done, once the scene's text has been read.
struct SceneTask {
    Task task;
    int (*run)(SceneSteps&);
};

constexpr auto scene_tasks = std::to_array<SceneTask>({
    {Task::render, render_picture},
    {Task::check, check_scene},
    {Task::check_syntax, check_syntax},
    {Task::dump_tokens, dump_stage},
    {Task::dump_tree, dump_stage},
    {Task::dump_scene, dump_stage},
    {Task::dump_world, dump_stage},
    {Task::dump_index, dump_stage},
    {Task::export_mesh, export_mesh},
    {Task::measure, measure_light},
    {Task::balance, balance_light},
    {Task::pick, pick_pixel},
});

int run_task_of_options(SceneSteps& steps) {
    if (steps.console().preview) return show_preview(steps);
    const auto row = std::ranges::find(scene_tasks, steps.options().task, &SceneTask::task);
    return row == scene_tasks.end() ? exit_status::usage : row->run(steps);
}

}  // namespace

int run_scene(const Options& options, const Console& console, Diagnostics& diagnostics) {
    return run_over_scene(options, console, diagnostics, run_task_of_options);
}

int run_over_scene(const Options& options, const Console& console, Diagnostics& diagnostics,
                   const std::function<int(SceneSteps&)>& work) {
    int status = exit_status::scene;
    on_deep_stack(options.limits.stack_bytes, [&](std::size_t) {
        SceneSteps steps(options, console, diagnostics);
        status = steps.open();
        if (status == exit_status::done) status = work(steps);
    });
    return status;
}

}  // namespace candelabra
