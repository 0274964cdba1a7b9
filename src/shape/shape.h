// SPDX-License-Identifier: GPL-3.0-or-later
// All shapes. The variant's list is the registry: a shape added here is known to the language, the
// manual, the conformance tests and the tracer.
#pragma once

#include "shape/bicubic_patch.h"
#include "shape/blob.h"
#include "shape/box.h"
#include "shape/cone.h"
#include "shape/cylinder.h"
#include "shape/disc.h"
#include "shape/height_field.h"
#include "shape/isosurface.h"
#include "shape/julia_fractal.h"
#include "shape/lathe.h"
#include "shape/mesh.h"
#include "shape/ovus.h"
#include "shape/parametric.h"
#include "shape/plane.h"
#include "shape/polygon.h"
#include "shape/polynomial.h"
#include "shape/prism.h"
#include "shape/quadric.h"
#include "shape/sor.h"
#include "shape/sphere.h"
#include "shape/sphere_sweep.h"
#include "shape/superellipsoid.h"
#include "shape/text.h"
#include "shape/torus.h"
#include "shape/triangle.h"
#include "shape/triangle_mesh.h"
#include "vocabulary/kinds.h"

#include <string>

namespace candelabra {

/// Shapes as scenes define them. Large ones are shared by their copies.
using Shape =
    std::variant<Sphere, Cuboid, Plane, Disc, Cylinder, Cone, Shared<Triangle>,
                 Shared<SmoothTriangle>, Shared<Mesh>, Torus, Shared<Quadric>, Shared<Cubic>,
                 Shared<Quartic>, Shared<Poly>, Shared<Polynomial>, Superellipsoid, Shared<Polygon>,
                 Shared<Prism>, Shared<Lathe>, Shared<Sor>, Ovus, Shared<SphereSweep>, Shared<Blob>,
                 Shared<Isosurface>, Shared<Parametric>, Shared<HeightField>, Shared<BicubicPatch>,
                 Shared<JuliaFractal>, Shared<Text>, Shared<TriangleMesh>>;

namespace shape_detail {

template <class T>
const T& content(const T& shape) {
    return shape;
}
template <class T>
const T& content(const Shared<T>& shape) {
    return *shape;
}

}  // namespace shape_detail

/// Calls f with the shape itself, independent of its kind and storage.
template <class F, class... T>
decltype(auto) visit_shape(F&& f, const std::variant<T...>& shape) {
    return std::visit(
        [&](const auto& stored) -> decltype(auto) { return f(shape_detail::content(stored)); },
        shape);
}

/// Error in a shape that the ranges of its fields do not exclude, as a sentence; empty when there
/// is none. This is the default for shapes without an overload of their own.
template <class T>
std::string problem(const T&) {
    return {};
}

/// Error in the shape, as a sentence; empty when there is none. Precondition of built() is that it
/// is empty.
std::string problem(const Shape& shape);

/// Reason why no point of a valid shape is visible: "its radius is 0". Such shapes come from loops
/// and animations, and are left out. Empty when some point is visible. This is the default for
/// shapes without an overload of their own.
template <class T>
std::string vanishes(const T&) {
    return {};
}

/// The same for any kind of shape.
std::string vanishes(const Shape& shape);

}  // namespace candelabra
