// SPDX-License-Identifier: GPL-3.0-or-later
// The GGX distribution of microfacets with Smith's masking (Walter and others, "Microfacet Models
// for Refraction through Rough Surfaces", 2007). A width is the square of a roughness.
#pragma once

#include "base/circle.h"
#include "base/vector.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candelabra {

/// Width of the facets of a surface; smoother ones would have infinite densities.
inline double facet_width(double roughness) { return std::max(roughness * roughness, 1e-3); }

/// Density of facets at this cosine between their normal and the surface's.
inline double facet_density(double width, double cosine) {
    const double d = cosine * cosine * (width * width - 1) + 1;
    return width * width / (std::numbers::pi * d * d);
}

/// Smith's masking of facets in a direction, over twice its cosine.
inline double unhidden(double width, double cosine) {
    return 1 / (cosine + std::sqrt(width * width + (1 - width * width) * cosine * cosine));
}

/// Draws the normal of a facet in proportion to its visible area: Heitz, "Sampling the GGX
/// Distribution of Visible Normals", 2018. In a space whose z axis is the surface's normal.
inline Vec3 visible_facet(const Vec3& viewer, double width, Vec2 place) {
    const Vec3 stretched = unit(Vec3(width * viewer.x, width * viewer.y, viewer.z));
    const double flat = stretched.x * stretched.x + stretched.y * stretched.y;
    const Vec3 side =
        flat > 0 ? Vec3(-stretched.y, stretched.x, 0) / std::sqrt(flat) : Vec3(1, 0, 0);
    const Vec3 above = cross(stretched, side);
    const Vec2 turned = on_circle(2 * std::numbers::pi * place.y);
    const double radius = std::sqrt(place.x), share = 0.5 * (1 + stretched.z);
    const double a = radius * turned.x;
    const double b = (1 - share) * std::sqrt(std::max(0.0, 1 - a * a)) + share * radius * turned.y;
    const Vec3 n = a * side + b * above + std::sqrt(std::max(0.0, 1 - a * a - b * b)) * stretched;
    return unit(Vec3(width * n.x, width * n.y, std::max(1e-9, n.z)));
}

/// (1 - cosine)^5, the term of Schlick's approximation of Fresnel's equations.
inline double grazing_share(double cosine) {
    const double x = std::clamp(1 - cosine, 0.0, 1.0);
    return x * x * x * x * x;
}

/// That approximation; `facing` is the reflectance at normal incidence.
inline double schlick(double facing, double cosine) {
    return facing + (1 - facing) * grazing_share(cosine);
}

}  // namespace candelabra
