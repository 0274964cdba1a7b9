// SPDX-License-Identifier: GPL-3.0-or-later
// Renders a shot to a picture. Each sample is a pure function of shot, settings, seed, pixel and
// sample number, and sums are exact. So the picture has the same bytes for any number of threads,
// and however often the work is stopped and continued.
#pragma once

#include "render/hooks.h"
#include "render/plan.h"
#include "transport/light_ledger.h"

namespace candelabra {

struct Rendering {
    Image image;
    LightLedger rays;
};

/// Renders a whole picture.
Rendering render(const Shot&, const RenderSettings&, const RenderHooks& = {});

/// Continues a picture until it is finished. Returns false if `cancelled` has stopped it. Adds to
/// the ledger.
bool advance(const RenderPlan&, RenderState&, LightLedger&, const RenderHooks& = {});

}  // namespace candelabra
