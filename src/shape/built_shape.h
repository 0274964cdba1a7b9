// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes as rays ask them: what the tracer, composites and luminaires hold. The list of kinds is
// that of Shape; what takes work to make ready is built once and shared by its copies.
#pragma once

#include "index/settings.h"
#include "shape/shape.h"

#include <concepts>

namespace candelabra {

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

}  // namespace shape_detail

/// Shapes as rays ask them: computed from Shape.
using BuiltShape = typename shape_detail::BuiltOf<Shape>::type;

/// The shape made ready, its parts found by an index. Precondition: problem() is empty.
BuiltShape built(const Shape& shape, const RayIndex& = {});

/// Smallest known box around the shape; infinite for planes.
Box bounds(const BuiltShape& shape);
/// All crossings of the whole line, also behind its origin (t < 0), in any order; normals point
/// outward. A solid is entered before it is left, and a line that only touches it does not cross
/// it.
void crossings(const BuiltShape& shape, const Ray& ray, Crossings& found);
/// Some of the crossings: the nearest one in the range is among them, if there is one.
void crossings_in(const BuiltShape& shape, const Ray& ray, const Interval& range, Crossings& found);
/// All crossings in the range, and maybe others.
void all_crossings_in(const BuiltShape& shape, const Ray& ray, const Interval& range,
                      Crossings& found);
/// Whether the point is in the solid; always false for shapes without an inside.
bool inside(const BuiltShape& shape, const Vec3& point);
/// A box outside of which no point is inside; for half spaces it is infinite in some directions.
/// This is the answer for shapes that have none of their own.
template <ShapeKind T>
Box inside_bounds(const T& shape) {
    return bounds(shape);
}
Box inside_bounds(const BuiltShape& shape);

}  // namespace candelabra
