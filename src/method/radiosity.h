// SPDX-License-Identifier: GPL-3.0-or-later
// POV-Ray's `radiosity` block: interreflection between diffuse surfaces. It is computed without a
// cache, so the parameters of the cache have no effect.
#pragma once

#include "base/rgb.h"
#include "vocabulary/item_info.h"

#include <string>

namespace candelabra {

struct Radiosity {
    int recursion_limit = 2;    ///< diffuse reflections before the visible surface
    double brightness = 1;      ///< factor at each of them
    double gray_threshold = 0;  ///< fraction of the light that turns grey at each of them
    double max_sample = -1;  ///< maximum channel of light from one direction; not above 0: no bound
    bool normal = false;     ///< gather light around the perturbed normal
    bool media = false;      ///< fog affects gathered light
    // Parameters of POV-Ray's cache and its effort.
    int count = 35;
    int directions = 1600;
    double error_bound = 1.8;
    int nearest_count = 5;
    int nearest_at_least = 0;
    double low_error_factor = 0.5;
    double minimum_reuse = 0.015, maximum_reuse = 0.2;
    double pretrace_start = 0.08, pretrace_end = 0.04;
    double adc_bailout = 0.01;
    bool always_sample = false;
    bool subsurface = false;
    std::string save_file = {}, load_file = {};
    bool on = false;  ///< the block is present

    static const ItemInfo vocabulary;
};

/// Returns the gathered part of the radiance from one direction: bounded by `max_sample`, scaled by
/// `brightness` and partly turned grey.
Rgb gathered_light(const Radiosity&, const Rgb& radiance);
/// The same without the bound, for light whose directions are not known.
Rgb reflected_light(const Radiosity&, const Rgb& light);

}  // namespace candelabra
