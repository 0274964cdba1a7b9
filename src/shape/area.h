// SPDX-License-Identifier: GPL-3.0-or-later
// Points distributed uniformly over the surface of a shape, which every luminaire can fall back on.
// Called by the luminaires. The points are on the surface to within rounding; smooth triangles give
// their flat normal.
#pragma once

#include "shape/built_shape.h"

namespace candelabra {

/// A point of a surface, with the outward unit normal there.
struct SurfacePoint {
    Vec3 position = Vec3(0);
    Vec3 normal = Vec3(0);
};

/// Area of the surface; 0 for shapes whose surface cannot be sampled, such as unbounded planes.
double surface_area(const Sphere&);
double surface_area(const Cuboid&);
double surface_area(const Disc&);
double surface_area(const Cylinder&);
double surface_area(const Cone&);
double surface_area(const Triangle&);
double surface_area(const SmoothTriangle&);
double surface_area(const BuiltMesh&);
template <ShapeKind T>
double surface_area(const T&) {
    return 0;
}

/// Maps u, uniform in [0, 1)^2, to a point that is uniform over the area. Precondition: the area is
/// above 0.
SurfacePoint sample_area(const Sphere&, const Vec2& u);
SurfacePoint sample_area(const Cuboid&, const Vec2& u);
SurfacePoint sample_area(const Disc&, const Vec2& u);
SurfacePoint sample_area(const Cylinder&, const Vec2& u);
SurfacePoint sample_area(const Cone&, const Vec2& u);
SurfacePoint sample_area(const Triangle&, const Vec2& u);
SurfacePoint sample_area(const SmoothTriangle&, const Vec2& u);
SurfacePoint sample_area(const BuiltMesh&, const Vec2& u);
template <ShapeKind T>
SurfacePoint sample_area(const T&, const Vec2&) {
    return {};
}

inline double surface_area(const BuiltShape& shape) {
    return visit_shape([](const auto& s) { return surface_area(s); }, shape);
}
inline SurfacePoint sample_area(const BuiltShape& shape, const Vec2& u) {
    return visit_shape([&](const auto& s) { return sample_area(s, u); }, shape);
}

}  // namespace candelabra
