// SPDX-License-Identifier: GPL-3.0-or-later
// What light cost: a table of the scene's statements that make lights, and layers of the picture.
// For --light-report and --light-layers.
#pragma once

#include "picture/layers.h"
#include "render/film.h"
#include "render/statistics.h"
#include "text/source.h"
#include "world/world.h"

#include <string>

/// A line for each statement of the scene that made luminaires or light sources, the brightest
/// first: its share of all light that came to hits from lights, its share of the shadow rays, how
/// many lights it made, and its place. Rays that met no luminaire have the last line.
std::string light_report(const World&, const RayCounts&, const SourceStore&);

/// The picture with two layers more: `shadow_rays`, how many a pixel's samples took, and
/// `variance`, of the pixel's mean as a display shows it (each channel 0 to 1, the greatest of the
/// three).
LayeredPicture light_layers(const Film&);
