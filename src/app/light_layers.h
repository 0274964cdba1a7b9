// SPDX-License-Identifier: GPL-3.0-or-later
// What light cost and how noisy it is, pixel by pixel, as layers of an OpenEXR file. For
// --light-layers.
#pragma once

#include "render/film.h"
#include "text/diagnostic.h"

#include <string>

/// Writes the picture with two layers more: `shadow_rays`, how many a pixel's samples took, and
/// `variance`, of the pixel's mean as a display shows it (each channel 0 to 1, the greatest of the
/// three). False, with a diagnostic, when that fails.
bool write_light_layers(const Film&, const std::string& path, Diagnostics&);
