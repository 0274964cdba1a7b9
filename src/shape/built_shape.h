// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes in the form that rays are tested against, held by the tracer, composites and luminaires.
// The kinds are those of Shape; a form that is costly to build is built once and shared by copies.
#pragma once

#include "index/settings.h"
#include "shape/shape.h"

#include <concepts>

namespace candelabra {

/// A kind of shape that build() converts to another form for ray tests.
template <class T>
concept Prepared = requires(const T& shape) {
    build(shape);
};

/// The form of the shape for ray tests: the result of build(), or the shape itself.
template <class T>
decltype(auto) ready(const T& shape) {
    if constexpr (Prepared<T>)
        return build(shape);
    else
        return (shape);
}

/// The operations that every shape supports once it is ready: its bounds, all its crossings with a
/// ray, and the test whether a point is inside.
template <class T>
concept ShapeKind = requires(const T& shape, const Ray& ray, Crossings& found, const Vec3& point) {
    { bounds(shape) } -> std::same_as<Box>;
    crossings(shape, ray, found);
    { inside(shape, point) } -> std::same_as<bool>;
};

namespace shape_detail {

template <class Stored>
using Ready = std::remove_cvref_t<decltype(ready(std::declval<const ContentOf<Stored>&>()))>;

/// An alternative of BuiltShape: the one of Shape, or a handle to the form built from it.
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

}  // namespace shape_detail

/// Shapes in the form for ray tests, computed from Shape.
using BuiltShape = typename shape_detail::BuiltOf<Shape>::type;

/// Builds the shape; `index` configures the index of its parts. Precondition: problem() is empty.
BuiltShape built(const Shape& shape, const RayIndex& = {});

/// Smallest known bounding box of the shape; infinite for planes.
Box bounds(const BuiltShape& shape);
/// Finds all crossings of the whole line, including those behind its origin (t < 0), in any order;
/// normals point outward. A solid is entered before it is left. A line that only touches a solid
/// does not cross it.
void crossings(const BuiltShape& shape, const Ray& ray, Crossings& found);
/// Finds some of the crossings; if any are in the range, the nearest one there is among them.
void crossings_in(const BuiltShape& shape, const Ray& ray, const Interval& range, Crossings& found);
/// Finds all crossings in the range, and possibly others.
void all_crossings_in(const BuiltShape& shape, const Ray& ray, const Interval& range,
                      Crossings& found);
/// Whether the point is in the solid; always false for shapes without an inside.
bool inside(const BuiltShape& shape, const Vec3& point);
/// A box that contains every point inside; infinite in some directions for half spaces. This is the
/// default for shapes without an overload of their own.
template <ShapeKind T>
Box inside_bounds(const T& shape) {
    return bounds(shape);
}
Box inside_bounds(const BuiltShape& shape);

/// The address of the content that copies of the shape share; null if each has its own.
inline const void* shared_content(const BuiltShape& shape) {
    return std::visit(
        [](const auto& stored) -> const void* {
            if constexpr (requires { *stored; })
                return &*stored;
            else
                return nullptr;
        },
        shape);
}

}  // namespace candelabra
