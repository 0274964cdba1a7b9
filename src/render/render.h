// SPDX-License-Identifier: GPL-3.0-or-later
// World to picture. Each pixel is a pure function of world, settings and seed, so the picture has
// the same bytes for any number of threads.
#pragma once

#include "base/image.h"
#include "render/statistics.h"
#include "scene/settings.h"
#include "world/world.h"

#include <functional>

/// What the caller may want to know while a picture is made. Both may be called from several
/// threads, and may be empty.
struct RenderHooks {
    std::function<void(double fraction)> progress;
    std::function<bool()> cancelled;  ///< true: stop soon and return what there is
};

struct Rendering {
    Image image;
    RayCounts rays;
};

Rendering render(const World&, const RenderSettings&, const RenderHooks& = {});

/// Camera rays a pixel that settings ask for, with the automatic choice made: one where nothing is
/// left to chance.
int samples_per_pixel(const World&, const RenderSettings&);
