// SPDX-License-Identifier: GPL-3.0-or-later
// POV-Ray's `radiosity` block: the light that diffuse surfaces get from each other. It is computed
// without a cache, so that words about the cache have no meaning here.
#pragma once

#include "vocabulary/item_info.h"

#include <string>

namespace candelabra {

struct Radiosity {
    int recursion_limit = 2;  ///< diffuse reflections on the way of light to a surface that is seen
    double brightness = 1;    ///< factor at each of them
    double gray_threshold = 0;  ///< share of the gathered light that becomes grey at each of them
    double max_sample = -1;  ///< greatest channel of light from one direction; 0 and less: no bound
    bool normal = false;     ///< light is gathered about the disturbed normal
    bool media = false;      ///< fog is there for light that is gathered
    // Words of POV-Ray's cache and of its effort.
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
    bool on = false;  ///< the block is there

    static const ItemInfo vocabulary;
};

/// What of the radiance from one direction is gathered: with the bound, the brightness and the loss
/// of colour that the block says.
Vec3 gathered_light(const Radiosity&, const Vec3& radiance);
/// The same without the bound: of light that is not known direction by direction.
Vec3 reflected_light(const Radiosity&, const Vec3& light);

}  // namespace candelabra
