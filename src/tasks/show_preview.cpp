// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/show_preview.h"

#include "output/layers.h"
#include "preview/renderer.h"
#include "tasks/frame_film.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace candelabra {

int show_preview(SceneSteps& steps) {
    std::optional<Scene> scene = steps.valid_scene();
    if (!scene) return exit_status::scene;
    const SharedWorld world =
        steps.reviewed_world(std::move(*scene), Session::Shutter::all_samples);
    if (!world) return exit_status::scene;
    const std::vector<std::string> lights = light_names(*world, steps.sources());
    const WorldView& view = world->stated_view;
    const Options& options = steps.options();
    steps.console().preview({world, steps.sources(), options, steps.output().format,
                             film_of_frame(film_in(view.camera, view.film), options), lights});
    return exit_status::done;
}

}  // namespace candelabra
