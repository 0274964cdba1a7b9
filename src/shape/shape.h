// SPDX-License-Identifier: GPL-3.0-or-later
// Every shape there is. The variant's list is the registry: a shape added here is known to the
// language, the manual, the conformance tests and the tracer.
#pragma once

#include "shape/blob.h"
#include "shape/box.h"
#include "shape/cone.h"
#include "shape/cylinder.h"
#include "shape/disc.h"
#include "shape/lathe.h"
#include "shape/mesh.h"
#include "shape/ovus.h"
#include "shape/plane.h"
#include "shape/polygon.h"
#include "shape/polynomial.h"
#include "shape/prism.h"
#include "shape/quadric.h"
#include "shape/sor.h"
#include "shape/sphere.h"
#include "shape/sphere_sweep.h"
#include "shape/superellipsoid.h"
#include "shape/torus.h"
#include "shape/triangle.h"
#include "vocabulary/kinds.h"

#include <concepts>

/// Shapes as they are written. Those that take much room are shared by their copies.
using Shape =
    std::variant<Sphere, Cuboid, Plane, Disc, Cylinder, Cone, Shared<Triangle>,
                 Shared<SmoothTriangle>, Shared<Mesh>, Torus, Shared<Quadric>, Shared<Cubic>,
                 Shared<Quartic>, Shared<Poly>, Superellipsoid, Shared<Polygon>, Shared<Prism>,
                 Shared<Lathe>, Shared<Sor>, Ovus, Shared<SphereSweep>, Shared<Blob>>;

/// A kind of shape that is made ready for rays: build() gives what they ask instead of it.
template <class T>
concept Prepared = requires(const T& shape) {
    build(shape);
};

/// The shape as rays ask it: what build() makes of it, or the shape itself.
template <class T>
decltype(auto) ready(const T& shape) {
    if constexpr (Prepared<T>)
        return build(shape);
    else
        return (shape);
}

/// What every shape can do once it is ready: bound itself, find all its crossings with a ray, tell
/// inside from outside.
template <class T>
concept ShapeKind = requires(const T& shape, const Ray& ray, Crossings& found, const Vec3& point) {
    { bounds(shape) } -> std::same_as<Box>;
    crossings(shape, ray, found);
    { inside(shape, point) } -> std::same_as<bool>;
};

/// What is wrong with a shape beyond the ranges of its fields, as a sentence; empty when nothing
/// is. This is the answer for shapes that have no problem() of their own.
template <class T>
std::string problem(const T&) {
    return {};
}

namespace shape_detail {

template <class Stored>
using Ready = std::remove_cvref_t<decltype(ready(std::declval<const ContentOf<Stored>&>()))>;

/// An alternative of BuiltShape: the one of Shape, or a handle of what is built from it.
template <class Stored>
using Built = std::conditional_t<Prepared<ContentOf<Stored>>, Shared<Ready<Stored>>, Stored>;

/// A variant of the types without repetitions.
template <class Found, class... Rest>
struct Distinct {
    using type = Found;
};
template <class... Found, class Next, class... Rest>
struct Distinct<std::variant<Found...>, Next, Rest...> {
    using type =
        typename Distinct<std::conditional_t<(std::is_same_v<Found, Next> || ...),
                                             std::variant<Found...>, std::variant<Found..., Next>>,
                          Rest...>::type;
};

template <class Variant>
struct BuiltOf;
template <class... T>
struct BuiltOf<std::variant<T...>> {
    static_assert((ShapeKind<Ready<T>> && ...));
    using type = typename Distinct<std::variant<>, Built<T>...>::type;
};

template <class T>
const T& content(const T& shape) {
    return shape;
}
template <class T>
const T& content(const Shared<T>& shape) {
    return *shape;
}

}  // namespace shape_detail

/// Shapes as rays ask them: computed from Shape.
using BuiltShape = typename shape_detail::BuiltOf<Shape>::type;

/// Calls f with the shape itself, whatever it is and however it is stored.
template <class F, class... T>
decltype(auto) visit_shape(F&& f, const std::variant<T...>& shape) {
    return std::visit(
        [&](const auto& stored) -> decltype(auto) { return f(shape_detail::content(stored)); },
        shape);
}

/// The shape made ready. Precondition: problem() is empty.
inline BuiltShape built(const Shape& shape) {
    return std::visit(
        [](const auto& stored) -> BuiltShape {
            using Stored = std::remove_cvref_t<decltype(stored)>;
            if constexpr (Prepared<ContentOf<Stored>>)
                return Shared(build(shape_detail::content(stored)));
            else
                return stored;
        },
        shape);
}

/// Smallest known box around the shape; infinite for planes.
inline Box bounds(const BuiltShape& shape) {
    return visit_shape([](const auto& s) { return bounds(s); }, shape);
}
/// All crossings of the whole line, also behind its origin (t < 0), in any order; normals point
/// outward. A solid is entered before it is left, and a line that only touches it does not cross
/// it.
inline void crossings(const BuiltShape& shape, const Ray& ray, Crossings& found) {
    visit_shape([&](const auto& s) { crossings(s, ray, found); }, shape);
}
/// Whether the point is in the solid; always false for shapes without an inside.
inline bool inside(const BuiltShape& shape, const Vec3& point) {
    return visit_shape([&](const auto& s) { return inside(s, point); }, shape);
}
/// A box outside of which no point is inside; for half spaces it is infinite in some directions.
/// This is the answer for shapes that have none of their own.
template <ShapeKind T>
Box inside_bounds(const T& shape) {
    return bounds(shape);
}
inline Box inside_bounds(const BuiltShape& shape) {
    return visit_shape([](const auto& s) { return inside_bounds(s); }, shape);
}
/// What is wrong with the shape, as a sentence; empty when nothing is, and only then may it be
/// asked for more.
inline std::string problem(const Shape& shape) {
    return visit_shape([](const auto& s) { return problem(s); }, shape);
}
