// SPDX-License-Identifier: GPL-3.0-or-later
// The usual task: the picture, with all files that belong to it.
#pragma once

#include "tasks/scene_steps.h"

namespace candelabra {

class Film;

/// A picture that has been rendered, for Console::finished.
struct FinishedPicture {
    const Film& film;
    const FilmFiles& files;  ///< what is made of the film
    const World& world;
    const LightLedger& rays;
    const SourceStore& sources;
};

/// Renders the picture or a shard of it, and writes it. Returns the exit status.
int render_picture(SceneSteps&);

}  // namespace candelabra
