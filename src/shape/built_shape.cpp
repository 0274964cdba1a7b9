// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/built_shape.h"

namespace candelabra {

BuiltShape built(const Shape& shape, const RayIndex& index) {
    return std::visit(
        [&](const auto& stored) -> BuiltShape {
            using Stored = std::remove_cvref_t<decltype(stored)>;
            if constexpr (requires { build(shape_detail::content(stored), index); })
                return Shared(build(shape_detail::content(stored), index));
            else if constexpr (Prepared<ContentOf<Stored>>)
                return Shared(build(shape_detail::content(stored)));
            else
                return stored;
        },
        shape);
}

Box bounds(const BuiltShape& shape) {
    return visit_shape([](const auto& s) { return bounds(s); }, shape);
}

void crossings(const BuiltShape& shape, const Ray& ray, Crossings& found) {
    visit_shape([&](const auto& s) { crossings(s, ray, found); }, shape);
}

void crossings_in(const BuiltShape& shape, const Ray& ray, const Interval& range,
                  Crossings& found) {
    visit_shape(
        [&](const auto& s) {
            if constexpr (requires { nearest_crossings(s, ray, range, found); })
                nearest_crossings(s, ray, range, found);
            else if constexpr (requires { crossings_between(s, ray, range, found); })
                crossings_between(s, ray, range, found);
            else
                crossings(s, ray, found);
        },
        shape);
}

void all_crossings_in(const BuiltShape& shape, const Ray& ray, const Interval& range,
                      Crossings& found) {
    visit_shape(
        [&](const auto& s) {
            if constexpr (requires { crossings_between(s, ray, range, found); })
                crossings_between(s, ray, range, found);
            else
                crossings(s, ray, found);
        },
        shape);
}

bool inside(const BuiltShape& shape, const Vec3& point) {
    return visit_shape([&](const auto& s) { return inside(s, point); }, shape);
}

Box inside_bounds(const BuiltShape& shape) {
    return visit_shape([](const auto& s) { return inside_bounds(s); }, shape);
}

}  // namespace candelabra
