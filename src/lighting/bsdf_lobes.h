// SPDX-License-Identifier: GPL-3.0-or-later
// How a surface scatters light, as the choice of luminaires knows it.
#pragma once

#include "base/function_ref.h"
#include "base/vector.h"

#include <array>
#include <cstddef>
#include <optional>

namespace candelabra {

/// Where a surface answers light more than elsewhere: by peak / (1 + sharpness (1 - cosine) / 2)^2
/// of light of colour 1 that makes that cosine with the axis, as facets do (GGX) and others
/// roughly. A white diffuse surface answers by the cosine to its normal.
struct Highlight {
    Vec3 axis = Vec3(0);  ///< unit
    double peak = 0, sharpness = 0;
};

struct BsdfLobes {
    double diffuse = 1;  ///< albedo of the diffuse part
    std::array<Highlight, 2> highlights = {};
    std::size_t count = 0;  ///< of highlights
};

/// Directions drawn as a surface scatters light.
struct BsdfSampler {
    double specular_probability = 0;  ///< share of the directions that highlights draw
    FunctionRef<std::optional<Vec3>(Vec2)> sample;
    FunctionRef<double(const Vec3&)> pdf;  ///< per steradian
};

}  // namespace candelabra
