// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/render.h"

#include "render/rounds.h"

namespace candelabra {

bool advance(const RenderPlan& plan, RenderState& state, LightLedger& rays,
             const RenderHooks& hooks) {
    Rounds rounds(plan, state, hooks);
    const bool finished = rounds.run();
    rays += rounds.rays();
    return finished;
}

Rendering render(const Shot& shot, const RenderSettings& settings, const RenderHooks& hooks) {
    RenderState state = begin_picture(settings, hooks.aovs.count(*shot.world));
    LightLedger rays;
    advance(plan_of(shot, settings), state, rays, hooks);
    return {state.film.image(), rays};
}

}  // namespace candelabra
