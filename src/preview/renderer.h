// SPDX-License-Identifier: GPL-3.0-or-later
// Renders a scene for the preview: coarse pictures first, then the samples that the run asks for.
// The page can move the camera without the scene being read again. Called by the preview with each
// scene that is ready.
#pragma once

#include "options/options.h"
#include "preview/state.h"
#include "text/source.h"
#include "world/world.h"

#include <functional>
#include <string>
#include <vector>

namespace candelabra {

/// A scene that is ready to render.
struct ReadyScene {
    SharedWorld world;
    const SourceStore& sources;
    const Options& options;
    PictureFormat format;                    ///< of the output picture
    FilmSettings film;                       ///< with the grain of this picture
    const std::vector<std::string>& lights;  ///< names of the statements that make lights
};

/// Conditions for leaving the scene. Both are called often, by any thread.
struct Leaving {
    std::function<bool()> soon;     ///< the scene has changed: one coarse picture is still made
    std::function<bool()> at_once;  ///< the run ends; implies soon
};
void render_preview(const ReadyScene&, PreviewState&, const Leaving&);

/// Pixels of the whole picture to one of the coarse ones, in each direction. The first step is
/// shown only if the second would come late.
inline constexpr int coarse_steps[] = {16, 8, 4, 2};

}  // namespace candelabra
