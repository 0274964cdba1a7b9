// SPDX-License-Identifier: GPL-3.0-or-later
// Scene to World: objects are taken apart into primitives with everything they inherit, luminaires
// are collected, and the index structures are built.
#pragma once

#include "text/diagnostic.h"
#include "text/source.h"
#include "world/world.h"

#include <functional>
#include <optional>

namespace candelabra {

struct CompileOptions {
    int threads = 0;                            ///< 0: one per core; nothing depends on it
    std::optional<LightSampler> light_sampler;  ///< overrides the scene's
    std::optional<RayIndex> index;              ///< the same
    int quality = 9;                            ///< see RenderSettings
    int width = 320, height = 240;   ///< of the picture; how fine light is looked at depends on it
    bool remembers_objects = false;  ///< Provenance::object_of is wanted
};

/// Where compile() gets the later scenes of a camera whose shutter stays open.
struct ShutterScenes {
    const SourceStore& sources;  ///< of all of them
    /// The scene when the clock has run on by so much. Nothing: it has errors; no more is asked
    /// for.
    std::function<std::optional<Scene>(double ahead)> scene_at;
};

/// Adds diagnostics for what cannot be rendered as written (a luminaire without area); the world is
/// complete all the same. Nothing may change it any more.
const World compile(const Scene&, const CompileOptions&, Diagnostics&);

/// The same for a scene that is not needed any more: its objects are given up before the index
/// structures are built, which then have more room. With the worlds of the shutter's other samples,
/// if their scenes can be had; what there is to say of these worlds is not said again.
const World compile(Scene&&, const CompileOptions&, Diagnostics&, const ShutterScenes* = nullptr);

/// The same diagnostics at a fraction of the cost, for whoever only checks a scene: the world has
/// its luminaires, and without lights its materials, but no ray can ask it.
const World survey(const Scene&, Diagnostics&);

}  // namespace candelabra
