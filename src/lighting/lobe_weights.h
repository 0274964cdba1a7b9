// SPDX-License-Identifier: GPL-3.0-or-later
// The light that the lobes of a surface reflect to the viewer, over that of a white diffuse
// surface, for light from a cone of directions. Cuts use the formula in single precision, the
// choice within a cluster in double precision.
#pragma once

#include "lighting/bsdf_lobes.h"
#include "lighting/tuning.h"
#include "luminaire/light_proxy.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace candelabra {

/// A highlight, ready for cones of directions: see Highlight. With a viewer, `along` and `across`
/// are perpendicular to the axis, in the viewer's plane and across it.
template <class T>
struct Peak {
    glm::vec<3, T> axis{0}, viewer{0}, along{0}, across{0};
    T peak = 0, sharpness = 0;
    bool by_half_vector = false;

    Peak() = default;
    explicit Peak(const Highlight& h)
        : axis(h.axis),
          viewer(h.viewer),
          peak(static_cast<T>(h.peak)),
          sharpness(static_cast<T>(h.sharpness)),
          by_half_vector(h.viewer != Vec3(0)) {
        if (!by_half_vector) return;
        const Vec3 in_plane = unit(h.viewer - dot(h.viewer, h.axis) * h.axis);
        const auto [x, y] = perpendiculars(h.axis);
        along = in_plane == Vec3(0) ? x : in_plane;
        across = in_plane == Vec3(0) ? y : cross(h.axis, in_plane);
    }
};

/// Minimum squared length of the sum of two unit vectors that is divided by: light from straight
/// behind the viewer's back has no half vector.
inline constexpr float min_half = 1e-6f;

/// Least reflectance of a highlight, spread over the cone of a sphere, over the cosine of its
/// height. v points from the receiver to its centre, n is the receiver's normal. Light that turns
/// by an angle turns the half vector by half of it in the viewer's plane, and across by the angle
/// over the length of the sum of both directions.
template <bool by_half_vector, class T>
[[gnu::always_inline]] inline T shine(const glm::vec<3, T>& v, const glm::vec<3, T>& n, T radius,
                                      const Peak<T>& peak) {
    constexpr T min_cosine = tuning::min_cosine;
    const T inverse = 1 / std::sqrt(outside_squared(v, radius));
    const T height = std::abs(dot(n, v)) * inverse;
    const T size = radius * inverse;
    const T lowest = size > min_cosine ? size : min_cosine;
    const T cosine = height > lowest ? height : lowest;
    const T spread = 1 + T(0.5) * peak.sharpness * size * size;
    if constexpr (by_half_vector) {
        const T turned = 2 + 2 * dot(peak.viewer, v) * inverse;
        const T per_half = 1 / (turned > T(min_half) ? turned : T(min_half));
        const T spread_across = 1 + 2 * peak.sharpness * size * size * per_half;
        const T along = dot(peak.along, v) * inverse + dot(peak.along, peak.viewer);
        const T across = dot(peak.across, v) * inverse;
        const T fallen = 1 + peak.sharpness * per_half *
                                 (along * along / spread + across * across / spread_across);
        return peak.peak /
               (std::sqrt(std::sqrt(spread * spread_across)) * cosine * fallen * fallen);
    } else {
        const T off = 1 - dot(peak.axis, v) * inverse;
        const T fallen = 1 + T(0.5) * peak.sharpness * (off > 0 ? off : 0) / spread;
        return peak.peak / (spread * cosine * fallen * fallen);
    }
}

/// All lobes of a surface with highlights.
template <class T>
struct LobeWeights {
    T diffuse = 1;
    std::array<Peak<T>, 2> peaks;
    std::size_t count = 0;
    T sharpness = 0;  ///< of the sharpest

    explicit LobeWeights(const BsdfLobes& lobes)
        : diffuse(static_cast<T>(std::fmax(lobes.diffuse, tuning::min_diffuse))),
          count(lobes.count) {
        for (std::size_t i = 0; i < count; ++i) {
            peaks[i] = Peak<T>(lobes.highlights[i]);
            sharpness = std::fmax(sharpness, peaks[i].sharpness);
        }
    }

    /// Reflected light of colour 1 from a sphere, over the irradiance.
    T reflected(const glm::vec<3, T>& v, const glm::vec<3, T>& n, T radius) const {
        T sum = diffuse;
        for (std::size_t i = 0; i < count; ++i)
            sum += peaks[i].by_half_vector ? shine<true>(v, n, radius, peaks[i])
                                           : shine<false>(v, n, radius, peaks[i]);
        return sum;
    }
};

}  // namespace candelabra
