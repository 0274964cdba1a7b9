// SPDX-License-Identifier: GPL-3.0-or-later
// A luminaire reduced to a few numbers, and the estimate of its irradiance from them, which is
// evaluated many millions of times a second. Used by the luminaires and by the light samplers, so
// that the formula exists only once.
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

/// Ratio of radius to distance at which rounding may still lift a luminaire above the horizon.
inline constexpr double horizon_slack = 1e-14;
/// Fraction of the squared radius; points whose squared distance from the centre is below it are
/// inside.
inline constexpr double inside_share = 1 - 2e-9;

/// Extent of a luminaire along this normal from its centre: the smaller of those of its box and its
/// sphere. Never quite 0.
[[gnu::always_inline]] inline double reach_along(const Vec3& n, const Vec3& half, double radius) {
    const double of_box = std::abs(n.x) * half.x + std::abs(n.y) * half.y + std::abs(n.z) * half.z;
    const double least = 1e-3 * radius, reach = of_box > least ? of_box : least;
    return reach < radius ? reach : radius;
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
template <Horizon horizon>
[[gnu::always_inline]] inline double irradiance(const Vec3& v, const Vec3& n, double radius,
                                                double strength, double reach) {
    const double r2 = radius * radius;
    const double d2 = v.x * v.x + v.y * v.y + v.z * v.z;
    const double outside2 = d2 > r2 ? d2 : r2;
    const double distance = std::sqrt(outside2);
    const double inverse = 1 / distance;
    if constexpr (horizon == Horizon::none)
        return strength * radius * (d2 < r2 * inside_share ? 4 : 1) * inverse * inverse;
    constexpr bool both_sides = horizon == Horizon::both_sides;
    const double signed_height = n.x * v.x + n.y * v.y + n.z * v.z;
    const double height = both_sides ? std::abs(signed_height) : signed_height;
    const double cut = height < reach ? height : reach;
    double lifted = cut + reach + horizon_slack * distance;
    lifted = lifted > 0 ? lifted : 0;
    const double partly =
        both_sides ? 0.5 * (cut * cut / reach + reach) : 0.25 * lifted * lifted / reach;
    const double above = radius * (partly + (height - cut));
    const double surrounded = (both_sides ? 2 : 1) * radius * reach;
    const double within = d2 < r2 * inside_share ? surrounded : 0;
    const double seen = above > within ? above : within;
    return strength * seen * inverse * inverse * inverse;
}

/// The same for a luminaire as thick as its sphere.
template <Horizon horizon>
[[gnu::always_inline]] inline double irradiance(const Vec3& v, const Vec3& n, double radius,
                                                double strength) {
    return irradiance<horizon>(v, n, radius, strength, radius);
}

/// Factor for the direction in which a flat luminaire is seen; 1 for other luminaires.
[[gnu::always_inline]] inline double facing(const Vec3& v, double radius, const Vec3& axis,
                                            double evenness) {
    const double r2 = radius * radius;
    const double d2 = v.x * v.x + v.y * v.y + v.z * v.z;
    const double outside2 = d2 > r2 ? d2 : r2;
    return evenness + std::abs(axis.x * v.x + axis.y * v.y + axis.z * v.z) / std::sqrt(outside2);
}

/// Factor for the direction in which a luminaire that may have a bent normal is seen.
inline double turned(const LightProxy& g, const Vec3& v, double radius) {
    const double distance = std::sqrt(std::fmax(dot(v, v), radius * radius));
    const double seen = g.evenness + (std::abs(dot(g.axis, v)) - dot(g.bent_normal, v)) / distance;
    return std::fmax(seen, length(g.bent_normal) * (min_unoccluded + radius / distance));
}

/// Estimates the irradiance from one luminaire; see unoccluded().
inline double irradiance(const LightProxy& g, const Receiver& point) {
    const Vec3 v = g.centre - point.position;
    const double reach = reach_along(point.normal, g.half, g.radius);
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
