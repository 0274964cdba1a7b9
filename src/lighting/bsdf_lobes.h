// SPDX-License-Identifier: GPL-3.0-or-later
// The scattering of a surface, as far as the choice of luminaires takes it into account.
#pragma once

#include "base/function_ref.h"
#include "base/vector.h"

#include <array>
#include <cstddef>
#include <optional>

namespace candelabra {

/// A lobe in which a surface reflects more light than elsewhere. Of light of colour 1 whose
/// direction has a given cosine with the axis, it reflects peak / (1 + sharpness (1 - cosine) /
/// 2)^2. Facets (GGX) do this exactly, and other highlights approximately. A white diffuse surface
/// reflects the cosine with its normal.
struct Highlight {
    Vec3 axis = Vec3(0);  ///< unit
    double peak = 0, sharpness = 0;
};

struct BsdfLobes {
    double diffuse = 1;  ///< albedo of the diffuse part
    std::array<Highlight, 2> highlights = {};
    std::size_t count = 0;  ///< of highlights
};

/// Samples directions in proportion to a surface's scattering.
struct BsdfSampler {
    double specular_probability = 0;  ///< fraction of the directions that highlights sample
    FunctionRef<std::optional<Vec3>(Vec2)> sample;
    FunctionRef<double(const Vec3&)> pdf;  ///< per steradian
};

}  // namespace candelabra
