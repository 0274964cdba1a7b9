// SPDX-License-Identifier: GPL-3.0-or-later
// World to picture. Each sample is a pure function of world, settings, seed, pixel and its number,
// and sums are exact, so the picture has the same bytes for any number of threads, and however
// often the work is stopped and continued.
#pragma once

#include "render/extras.h"
#include "render/schedule.h"
#include "render/statistics.h"
#include "world/world.h"

#include <functional>

/// What the caller may want to know while a picture is made. Both may be called from several
/// threads, and may be empty.
struct RenderHooks {
    std::function<void(double fraction)> progress;  ///< of the whole picture
    std::function<bool()> cancelled;                ///< true: stop within some samples
    bool counts_lights = false;                     ///< fills RayCounts::lights
    Extras extras = {};                             ///< the film has sums for them
};

struct Rendering {
    Image image;
    RayCounts rays;
};

/// A whole picture at once.
Rendering render(const World&, const RenderSettings&, const RenderHooks& = {});

/// Goes on with a picture until it is finished; false when the hook has stopped it. Adds to the
/// counts.
bool advance(const World&, const RenderSettings&, RenderState&, RayCounts&, const RenderHooks&);

/// Camera rays a pixel that settings ask for, with the automatic choice made: one where nothing is
/// left to chance.
int samples_per_pixel(const World&, const RenderSettings&);

/// Whether all pixels get the same number of samples. Neither an adaptive scheme nor a lens is so.
bool is_even(const World&, const RenderSettings&);
