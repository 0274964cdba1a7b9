// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/geometry.h"

#include "world/prototype.h"

#include <algorithm>

namespace candelabra {

PrimitiveIndex Geometry::primitive(PrimitiveKind kind, std::uint32_t index) const {
    switch (kind) {
        case PrimitiveKind::sphere:
            return index;
        case PrimitiveKind::triangle:
            return triangles_begin() + index;
        case PrimitiveKind::shape:
            return shapes_begin() + index;
        case PrimitiveKind::leaf:
            break;
    }
    return leaves_begin() + index;
}

std::size_t Geometry::primitive_count() const {
    if (instances.empty()) return instanced_begin();
    return instances.back().first + prototype_of(instances.back()).primitive_count();
}

const Instance& Geometry::instance_of(PrimitiveIndex primitive) const {
    return *(std::ranges::upper_bound(instances, primitive, {}, &Instance::first) - 1);
}

Box Geometry::bounds(std::uint32_t item) const {
    if (const Instance* placed = instance(item))
        return placed->place->box(prototype_of(*placed).box);
    return visit(
        item,
        [](const SpherePrimitive& s) {
            return Box{s.centre - s.radius, s.centre + s.radius};
        },
        [](const TrianglePrimitive& t) {
            return join(join(Box{t.corner1, t.corner1}, t.corner2), t.corner3);
        },
        [](const PlacedShape& placed) { return placed.box; },
        [](const PlacedComposite& placed) { return placed.composite->bounds(); });
}

Box Geometry::finite_bounds(std::uint32_t item) const {
    return std::ranges::binary_search(infinite.all, item) ? Box() : bounds(item);
}

Box Geometry::inside_bounds(std::uint32_t item) const {
    if (const PlacedComposite* placed = composite(item)) return placed->composite->inside_bounds();
    const PlacedShape* placed = shape(item);
    if (!placed) return bounds(item);
    const Box box = candelabra::inside_bounds(placed->shape);
    return placed->transform ? placed->transform->box(box) : box;
}

Box Geometry::noticed_in(std::uint32_t item) const {
    if (const PlacedComposite* placed = composite(item))
        return clip(placed->composite->inside_bounds(), placed->around);
    const Box own = bounds(item);
    if (instance(item)) return own;
    return finite(own) ? own : inside_bounds(item);
}

}  // namespace candelabra
