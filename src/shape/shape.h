// SPDX-License-Identifier: GPL-3.0-or-later
// Every shape there is. The variant's list is the registry: a shape added here is known to the
// language, the manual, the conformance tests and the tracer.
#pragma once

#include "shape/box.h"
#include "shape/cone.h"
#include "shape/cylinder.h"
#include "shape/disc.h"
#include "shape/mesh.h"
#include "shape/plane.h"
#include "shape/sphere.h"
#include "shape/triangle.h"
#include "vocabulary/kinds.h"

#include <concepts>

/// Shapes that take much room are shared by their copies.
using Shape = std::variant<Sphere, Cuboid, Plane, Disc, Cylinder, Cone, Shared<Triangle>,
                           Shared<SmoothTriangle>, Shared<Mesh>>;

/// What every shape can do: bound itself, find all its crossings with a ray, tell inside from
/// outside.
template <class T>
concept ShapeKind = requires(const T& shape, const Ray& ray, Crossings& found, const Vec3& point) {
    { bounds(shape) } -> std::same_as<Box>;
    crossings(shape, ray, found);
    { inside(shape, point) } -> std::same_as<bool>;
};

/// What is wrong with a shape beyond the ranges of its fields, as a sentence; empty when nothing
/// is. This is the answer for shapes that have no problem() of their own.
template <ShapeKind T>
std::string problem(const T&) {
    return {};
}

namespace shape_detail {
template <class>
constexpr bool all_kinds = false;
template <class... T>
constexpr bool all_kinds<std::variant<T...>> = (ShapeKind<ContentOf<T>> && ...);
static_assert(all_kinds<Shape>);

template <class T>
const T& content(const T& shape) {
    return shape;
}
template <class T>
const T& content(const Shared<T>& shape) {
    return *shape;
}
}  // namespace shape_detail

/// Calls f with the shape itself, whatever it is and however it is stored.
template <class F>
decltype(auto) visit_shape(F&& f, const Shape& shape) {
    return std::visit(
        [&](const auto& stored) -> decltype(auto) { return f(shape_detail::content(stored)); },
        shape);
}

/// Smallest known box around the shape; infinite for planes.
inline Box bounds(const Shape& shape) {
    return visit_shape([](const auto& s) { return bounds(s); }, shape);
}
/// All crossings of the whole line, also behind its origin (t < 0), in any order; normals point
/// outward. A solid is entered before it is left, and a line that only touches it does not cross
/// it.
inline void crossings(const Shape& shape, const Ray& ray, Crossings& found) {
    visit_shape([&](const auto& s) { crossings(s, ray, found); }, shape);
}
/// Whether the point is in the solid; always false for shapes without an inside.
inline bool inside(const Shape& shape, const Vec3& point) {
    return visit_shape([&](const auto& s) { return inside(s, point); }, shape);
}
/// What is wrong with the shape, as a sentence; empty when nothing is, and only then may it be
/// asked for more.
inline std::string problem(const Shape& shape) {
    return visit_shape([](const auto& s) { return problem(s); }, shape);
}
