// SPDX-License-Identifier: GPL-3.0-or-later
// Scene to World: objects are taken apart into primitives with everything they inherit, luminaires
// are collected, and the index structures are built.
#pragma once

#include "text/diagnostic.h"
#include "world/world.h"

#include <optional>

struct CompileOptions {
    int threads = 0;                            ///< 0: one per core; nothing depends on it
    std::optional<LightSampler> light_sampler;  ///< overrides the scene's
    std::optional<RayIndex> index;              ///< the same
    int quality = 9;                            ///< see RenderSettings
    int width = 320, height = 240;   ///< of the picture; how fine light is looked at depends on it
    bool remembers_objects = false;  ///< Provenance::object_of is wanted
};

/// Adds diagnostics for what cannot be rendered as written (a luminaire without area); the world is
/// complete all the same.
World compile(const Scene&, const CompileOptions&, Diagnostics&);

/// The same for a scene that is not needed any more: its objects are given up before the index
/// structures are built, which then have more room.
World compile(Scene&&, const CompileOptions&, Diagnostics&);

/// The same diagnostics at a fraction of the cost, for whoever only checks a scene: the world has
/// its luminaires, and without lights its materials, but no ray can ask it.
World survey(const Scene&, Diagnostics&);
