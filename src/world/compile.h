// SPDX-License-Identifier: GPL-3.0-or-later
// Scene to World: objects are taken apart into primitives with all inherited attributes, luminaires
// are collected, and index structures are built. A Shot (world/shot.h) has what depends on the
// camera.
#pragma once

#include "text/diagnostic.h"
#include "text/source.h"
#include "world/instance_plan.h"
#include "world/world.h"

#include <functional>
#include <optional>

namespace candelabra {

struct CompileOptions {
    int threads = 0;                            ///< 0: one per core; the result is the same
    std::optional<LightSampler> light_sampler;  ///< overrides the scene's
    std::optional<RayIndex> index;              ///< overrides the scene's
    int quality = 9;                            ///< see RenderSettings
    bool remembers_objects = false;             ///< whether to fill Provenance::object_of
    bool follows_lamps = false;  ///< keeps luminaires also if no surface shows their light
    InstanceLimits instances = {};  ///< which unions are stored once; tests share smaller ones
    bool reviews = false;           ///< whether to warn of probable mistakes (world/review.h)
};

/// Source of the later scenes of a camera whose shutter stays open.
struct ShutterScenes {
    const SourceStore& sources;  ///< of all these scenes
    /// Returns the scene at a clock that is later by `ahead`. Nothing if it has errors; then no
    /// more scenes are requested.
    std::function<std::optional<Scene>(double ahead)> scene_at;
};

/// Adds diagnostics for objects that cannot be rendered as written (such as a luminaire without
/// area); the world is complete nevertheless.
SharedWorld compile(const Scene&, const CompileOptions&, Diagnostics&);

/// The same for a scene that is no longer needed: its objects are freed before the index structures
/// are built, which then have more room. Includes the worlds of the other shutter samples, if their
/// scenes are available; diagnostics of these worlds are not repeated.
SharedWorld compile(Scene&&, const CompileOptions&, Diagnostics&, const ShutterScenes* = nullptr);

/// Gives the same diagnostics at a fraction of the cost, for checking a scene. The world has its
/// luminaires and, if it has no lights, its materials, but it cannot be intersected with rays.
SharedWorld survey(const Scene&, Diagnostics&);

}  // namespace candelabra
