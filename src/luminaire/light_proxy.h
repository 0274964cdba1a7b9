// SPDX-License-Identifier: GPL-3.0-or-later
// A luminaire reduced to a few numbers, and the estimate of its irradiance from them, which is
// evaluated many millions of times a second. Luminaires and light samplers use the same formula:
// cuts of the light octree in single precision, all others in double precision.
#pragma once

#include "luminaire/luminaire.h"

namespace candelabra {

/// A luminaire as a sphere that glows evenly; a flat one emits more along its axis.
struct LightProxy {
    Vec3 centre = Vec3(0);
    double radius = 1;           ///< above 0
    double strength = 0;         ///< intensity / radius
    Vec3 axis = Vec3(0);         ///< 0: same intensity in all directions
    double evenness = 1;         ///< fraction of the intensity that is the same in all directions
    Vec3 half = Vec3(1e300);     ///< half the size of a bounding box around the centre, which may
                                 ///< be thinner than the sphere
    Vec3 bent_normal = Vec3(0);  ///< see with_bent_normal()
};

/// Evenness of flat luminaires: they are estimated to emit a little along their plane too, since
/// the estimate takes them to be at their centre.
inline constexpr double flat_evenness = 0.05;

inline LightProxy light_proxy(const LightBounds& b) {
    const bool flat = b.axis != Vec3(0);
    const double radius = std::fmax(b.radius, 1e-150);
    return {b.centre,
            radius,
            b.intensity / radius,
            b.axis,
            flat ? flat_evenness + b.evenness : 1,
            glm::max(b.box.high - b.centre, b.centre - b.box.low)};
}

/// Returns the proxy with the occlusion by its surroundings: in the unit direction d, its strength
/// is (1 - |bent_normal|) times the unoccluded strength, plus dot(bent_normal, d) times the
/// strength face-on.
inline LightProxy with_bent_normal(LightProxy g, const Vec3& bent_normal) {
    const double rest = 1 - length(bent_normal);
    g.axis *= rest;
    g.evenness *= rest;
    g.bent_normal = bent_normal;
    return g;
}

/// Fraction of the length of its bent normal that a luminaire keeps in every direction: the rays of
/// find_bent_normals() do not find every gap, and a nearby luminaire is seen in several directions
/// at once.
inline constexpr double min_unoccluded = 0.1;

/// What rounding requires of the estimate in each precision.
template <class T>
struct ProxyMargins;
template <>
struct ProxyMargins<double> {
    /// Ratio of radius to distance at which rounding may still lift a luminaire above the horizon.
    static constexpr double horizon_slack = 1e-14;
    /// Fraction of the squared radius; points whose squared distance from the centre is below it
    /// are inside.
    static constexpr double inside_share = 1 - 2e-9;
};
template <>
struct ProxyMargins<float> {
    static constexpr float horizon_slack = 1e-6f, inside_share = 1;
};

/// Extent of a luminaire along a normal from its centre: the smaller of those of its box and its
/// sphere. Never quite 0. `steep` has the absolute components of the normal.
template <class T>
[[gnu::always_inline]] inline T reach_along(const glm::vec<3, T>& steep, const glm::vec<3, T>& half,
                                            T radius) {
    const T of_box = steep.x * half.x + steep.y * half.y + steep.z * half.z;
    const T least = static_cast<T>(1e-3) * radius, reach = of_box > least ? of_box : least;
    return reach < radius ? reach : radius;
}

/// The squared distance to the centre, but at least the squared radius: what estimates divide by.
template <class T>
[[gnu::always_inline]] inline T outside_squared(const glm::vec<3, T>& v, T radius) {
    const T r2 = radius * radius, d2 = v.x * v.x + v.y * v.y + v.z * v.z;
    return d2 > r2 ? d2 : r2;
}

/// Irradiance from one sphere. Elementwise arithmetic without branches, so that loops over it are
/// vectorised, and so that every instruction set gives the same bits. v points from the receiver to
/// the centre, n is the receiver's normal.
///
/// With h = n.v, the irradiance is strength r h r / d^3 if the whole sphere is above the horizon.
/// Where the horizon cuts the sphere, strength (h + r)^2 r / 4 d^3 replaces the exact formula: the
/// two agree at h = r, and the second is zero only if the whole sphere is below, and never smaller
/// than the first. Luminaires flatter than their sphere are cut by the horizon within their reach
/// instead: strength (h + reach)^2 r^2 / (4 reach d^3). Inside the sphere, light arrives from all
/// directions. Without a horizon the estimate is strength r / d^2, and inside four times that of
/// one side.
template <Horizon horizon, class T>
[[gnu::always_inline]] inline T irradiance(const glm::vec<3, T>& v, const glm::vec<3, T>& n,
                                           T radius, T strength, T reach) {
    using Margins = ProxyMargins<T>;
    const T r2 = radius * radius, d2 = v.x * v.x + v.y * v.y + v.z * v.z;
    const T inside2 = r2 * Margins::inside_share;
    const T distance = std::sqrt(outside_squared(v, radius));
    const T inverse = 1 / distance;
    if constexpr (horizon == Horizon::none)
        return strength * radius * (d2 < inside2 ? T(4) : T(1)) * inverse * inverse;
    constexpr bool both_sides = horizon == Horizon::both_sides;
    const T signed_height = n.x * v.x + n.y * v.y + n.z * v.z;
    const T height = both_sides ? std::abs(signed_height) : signed_height;
    const T cut = height < reach ? height : reach;
    T lifted = cut + reach + Margins::horizon_slack * distance;
    lifted = lifted > 0 ? lifted : 0;
    const T partly =
        both_sides ? T(0.5) * (cut * cut / reach + reach) : T(0.25) * lifted * lifted / reach;
    const T above = partly + (height - cut);
    const T surrounded = both_sides ? 2 * reach : reach;
    const T within = d2 < inside2 ? surrounded : 0;
    return strength * radius * (above > within ? above : within) * inverse * inverse * inverse;
}

/// Factor for the direction in which a flat luminaire is seen; 1 for other luminaires. `outwards`
/// is the part of the bent normal along v, which weakens it.
template <class T>
[[gnu::always_inline]] inline T facing(const glm::vec<3, T>& v, T radius,
                                       const glm::vec<3, T>& axis, T evenness, T outwards = 0) {
    const T along = std::abs(axis.x * v.x + axis.y * v.y + axis.z * v.z);
    return evenness + (along - outwards) * (1 / std::sqrt(outside_squared(v, radius)));
}

/// The same for a luminaire that may have a bent normal, of the given length.
template <class T>
[[gnu::always_inline]] inline T turned(const glm::vec<3, T>& v, T radius,
                                       const glm::vec<3, T>& axis, T evenness,
                                       const glm::vec<3, T>& bent, T bent_length) {
    const T seen = facing(v, radius, axis, evenness, bent.x * v.x + bent.y * v.y + bent.z * v.z);
    const T inverse = 1 / std::sqrt(outside_squared(v, radius));
    const T least = bent_length * (static_cast<T>(min_unoccluded) + radius * inverse);
    return seen > least ? seen : least;
}

/// The same for a proxy, as seen along v.
inline double turned(const LightProxy& g, const Vec3& v, double radius) {
    return turned(v, radius, g.axis, g.evenness, g.bent_normal, length(g.bent_normal));
}

/// Estimates the irradiance from one luminaire; see unoccluded().
inline double irradiance(const LightProxy& g, const Receiver& point) {
    const Vec3 v = g.centre - point.position;
    const double reach = reach_along(glm::abs(point.normal), g.half, g.radius);
    const auto of_sphere = [&]<Horizon horizon>() {
        return irradiance<horizon>(v, point.normal, g.radius, g.strength, reach);
    };
    const double even = point.horizon == Horizon::one_side
                            ? of_sphere.template operator()<Horizon::one_side>()
                        : point.horizon == Horizon::both_sides
                            ? of_sphere.template operator()<Horizon::both_sides>()
                            : of_sphere.template operator()<Horizon::none>();
    if (g.bent_normal != Vec3(0)) return even * turned(g, v, g.radius);
    return g.axis == Vec3(0) ? even * g.evenness : even * facing(v, g.radius, g.axis, g.evenness);
}

}  // namespace candelabra
