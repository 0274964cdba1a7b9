// SPDX-License-Identifier: GPL-3.0-or-later
// A picture with all that it is made from, about which the page can ask questions.
#pragma once

#include "scene/settings.h"
#include "text/source.h"
#include "world/shot.h"

namespace candelabra {

class Film;
struct LightLedger;

/// An unfinished or finished picture, with all that it is made from.
struct RenderedPicture {
    const Shot& shot;
    const SourceStore& sources;
    const RenderSettings& settings;
    const Film& film;
    const LightLedger& rays;
};

}  // namespace candelabra
