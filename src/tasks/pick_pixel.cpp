// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/pick_pixel.h"

#include "film/schedule.h"
#include "preview/inspect.h"
#include "render/render.h"
#include "text/message.h"

#include <optional>
#include <utility>

namespace candelabra {

int pick_pixel(SceneSteps& steps) {
    const auto [x, y] = steps.options().picked;
    const RenderSettings& settings = steps.options().render;
    if (x >= settings.width || y >= settings.height) {
        steps.diagnostics().add(
            error(Fault::option, {},
                  message("--pick ", x, ",", y, " is outside of the picture of ", settings.width,
                          "x", settings.height, " pixels"))
                .with_help("both count from 0; +W and +H say how large the picture is"));
        steps.say_diagnostics();
        return exit_status::usage;
    }
    std::optional<Scene> scene = steps.valid_scene();
    if (!scene) return exit_status::scene;
    const SharedWorld world = steps.compiled(std::move(*scene), Session::Shutter::all_samples);
    if (!world) return exit_status::scene;
    const Shot shot = steps.shot(world);
    RenderState state = begin_picture(settings);
    state.shard.region = {x, y, x + 1, y + 1};
    state.film.keep_to_rows(y - 1, y + 2);
    LightLedger rays;
    advance(plan_of(shot, settings), state, rays);
    return steps.print(what_is_under({shot, steps.sources(), settings, state.film, rays}, x, y));
}

}  // namespace candelabra
