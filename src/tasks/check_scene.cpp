// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/check_scene.h"

#include "syntax/parser.h"
#include "text/message.h"
#include "text/printable.h"

#include <optional>
#include <utility>

namespace candelabra {

namespace {

int say_correct(const SceneSteps& steps) {
    const Options& options = steps.options();
    if (talks(options))
        say(steps.console(), Stream::render, message(printable(*options.scene), ": no errors\n"));
    return exit_status::done;
}

}  // namespace

int check_scene(SceneSteps& steps) {
    std::optional<Scene> scene = steps.valid_scene();
    if (!scene) return exit_status::scene;
    if (steps.options().stats_file.empty())
        return steps.reviewed(*scene) ? say_correct(steps) : exit_status::scene;
    const SharedWorld world =
        steps.reviewed_world(std::move(*scene), Session::Shutter::first_sample);
    if (!world) return exit_status::scene;
    const Shot shot = steps.shot(world);
    say_correct(steps);
    return steps.finish(shot, {});
}

int check_syntax(SceneSteps& steps) {
    Names names;
    parse(steps.session().main(), steps.sources(), names, steps.diagnostics());
    return steps.say_diagnostics() ? exit_status::scene : say_correct(steps);
}

}  // namespace candelabra
