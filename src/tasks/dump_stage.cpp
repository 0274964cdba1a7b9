// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/dump_stage.h"

#include "output/index_slice.h"
#include "output/world_report.h"
#include "scene/dump.h"
#include "syntax/dump.h"
#include "syntax/parser.h"

#include <optional>
#include <string>
#include <utility>

namespace candelabra {

namespace {

int dump_text(SceneSteps& steps) {
    Names names;
    const SourceId main = steps.session().main();
    const std::string text =
        steps.options().task == Task::dump_tokens
            ? dump_tokens(main, steps.sources(), names, steps.diagnostics())
            : dump(parse(main, steps.sources(), names, steps.diagnostics()), names);
    return steps.print(text);
}

int dump_scene(SceneSteps& steps) {
    const WrittenFunctions written;  // functions keep their text while it lives
    const Scene scene = steps.evaluated();
    return steps.print(steps.diagnostics().failed() ? "" : dump(scene));
}

int dump_world(SceneSteps& steps) {
    std::optional<Scene> scene = steps.valid_scene();
    if (!scene) return exit_status::scene;
    const SharedWorld world = steps.compiled(std::move(*scene), Session::Shutter::first_sample);
    if (!world) return exit_status::scene;
    return steps.print(steps.options().task == Task::dump_index ? index_slice(*world)
                                                                : report(*world));
}

}  // namespace

int dump_stage(SceneSteps& steps) {
    switch (steps.options().task) {
        case Task::dump_scene:
            return dump_scene(steps);
        case Task::dump_world:
        case Task::dump_index:
            return dump_world(steps);
        default:
            return dump_text(steps);
    }
}

}  // namespace candelabra
