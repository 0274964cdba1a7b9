// SPDX-License-Identifier: GPL-3.0-or-later
// The scattering of a surface, as far as the choice of luminaires takes it into account.
#pragma once

#include "base/function_ref.h"
#include "base/vector.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace candelabra {

/// A lobe in which a surface reflects more light than elsewhere: peak / (1 + sharpness x)^2 of
/// light of colour 1, where x is the squared sine of an angle. Facets (GGX) do this exactly, and
/// other highlights approximately. A white diffuse surface reflects the cosine with its normal.
struct Highlight {
    /// Unit. With a viewer: the normal, and the angle is that between it and the half vector of
    /// light and viewer, so that the lobe is narrow across the plane of a flat view. Without: the
    /// brightest direction, and the angle is half of that between it and the light.
    Vec3 axis = Vec3(0);
    double peak = 0, sharpness = 0;
    Vec3 viewer = Vec3(0);  ///< unit direction to the viewer; 0: none

    /// Reflected light of colour 1 from a unit direction.
    double reflected(const Vec3& to_light) const {
        const double cosine = dot(axis, to_light);
        double x = (1 - cosine) / 2;
        if (viewer != Vec3(0)) {
            const Vec3 half = unit(to_light + viewer);
            x = 1 - dot(axis, half) * dot(axis, half);
        }
        const double fallen = 1 + sharpness * x;
        return peak / (fallen * fallen);
    }

    /// About the fraction of light from all directions, each with the same radiance, that it
    /// reflects: reflected() over pi, integrated over the sphere. With a viewer, light turns by
    /// four times the cosine of the view as much solid angle as the half vector.
    double albedo() const {
        const double per_half = viewer == Vec3(0) ? 1 : std::fabs(dot(axis, viewer));
        return 4 * per_half * peak / (1 + sharpness);
    }
};

struct BsdfLobes {
    double diffuse = 1;  ///< albedo of the diffuse part
    std::array<Highlight, 2> highlights = {};
    std::size_t count = 0;  ///< of highlights

    /// Of all parts together.
    double albedo() const {
        double sum = diffuse;
        for (std::size_t i = 0; i < count; ++i) sum += highlights[i].albedo();
        return sum;
    }
};

/// Samples directions in proportion to a surface's scattering.
struct BsdfSampler {
    double specular_probability = 0;  ///< fraction of the directions that highlights sample
    FunctionRef<std::optional<Vec3>(Vec2)> sample;
    FunctionRef<double(const Vec3&)> pdf;  ///< per steradian
};

}  // namespace candelabra
