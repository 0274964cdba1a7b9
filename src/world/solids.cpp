// SPDX-License-Identifier: GPL-3.0-or-later
// The solids that contain a point, or that a ray enters and leaves.
#include "world/prototype.h"
#include "world/world.h"

#include <algorithm>

namespace candelabra {

namespace {

/// Whether an item that is no instance contains the point.
bool is_within(const Geometry& geometry, std::uint32_t item, const Vec3& point) {
    return geometry.visit(
        item, [&](const SpherePrimitive& s) { return length(point - s.centre) < s.radius; },
        [](const TrianglePrimitive&) { return false; },
        [&](const PlacedShape& placed) {
            return inside(placed.shape,
                          placed.transform ? placed.transform->inverse_point(point) : point);
        },
        [&](const PlacedComposite& placed) { return placed.composite->inside(point); });
}

/// Whether a solid that rays cannot enter keeps out fog and media.
bool keeps_out(const World& world, const Material& outer) {
    return world.facts.dims_between && !outer.hollow;
}

/// Whether an item is a noted solid. `first`: the number in the world of the first primitive of its
/// geometry. An opaque solid may contain the camera, or have holes through which its inside shows.
bool is_noted(const World& world, const Geometry& geometry, PrimitiveIndex first,
              std::uint32_t item) {
    if (geometry.is_triangle(item)) return false;
    if (const Instance* instance = geometry.instance(item))
        return world.facts.dims_between || geometry.prototype_of(*instance).has_interiors;
    const PlacedComposite* placed = geometry.composite(item);
    const Material& outer = world.material(first + (placed ? placed->first_leaf : item));
    return keeps_out(world, outer) || outer.interior ||
           (placed ? placed->transparent : outer.transparent);
}

/// Adds a noted solid if it contains the point; a composite by the leaf whose interior applies; of
/// an instance, its noted solids.
void add_if_inside(const World& world, const Geometry& geometry, PrimitiveIndex first,
                   std::uint32_t item, const Vec3& point, EnteredSolids& found) {
    if (!contains(geometry.noticed_in(item), point)) return;
    if (const Instance* instance = geometry.instance(item)) {
        const Geometry& own = geometry.prototype_of(*instance).geometry;
        const Vec3 here = instance->place->inverse_point(point);
        for (std::uint32_t part = 0; part < own.item_count(); ++part)
            if (is_noted(world, own, instance->first, part))
                add_if_inside(world, own, instance->first, part, here, found);
        return;
    }
    if (!is_within(geometry, item, point)) return;
    const PlacedComposite* placed = geometry.composite(item);
    if (!placed) return found.push_back(first + item);
    // The solid's interior is the one behind its first transparent leaf.
    PrimitiveIndex leaf = first + placed->first_leaf;
    while (placed->transparent && !world.material(leaf).transparent) ++leaf;
    found.push_back(leaf);
}

}  // namespace

bool World::contains_point(PrimitiveIndex primitive, const Vec3& point) const {
    if (!geometry.is_instanced(primitive))
        return is_within(geometry, geometry.item_of(primitive), point);
    const Instance& placed = geometry.instance_of(primitive);
    const Geometry& own = geometry.prototype_of(placed).geometry;
    return is_within(own, own.item_of(primitive - placed.first),
                     placed.place->inverse_point(point));
}

bool World::is_noted_solid(std::uint32_t item) const { return is_noted(*this, geometry, 0, item); }

EnteredSolids World::containing(const Vec3& point) const {
    EnteredSolids found;
    if (!facts.notes_solids) return found;
    if (facts.indexes_solids) {
        for (const std::uint32_t item : geometry.clear_solids.infinite)
            add_if_inside(*this, geometry, 0, item, point, found);
        geometry.clear_solids.index.around(point, [&](std::uint32_t part) {
            add_if_inside(*this, geometry, 0, geometry.clear_solids.finite[part], point, found);
        });
        return found;
    }
    for (std::uint32_t item = 0; item < geometry.item_count(); ++item)
        if (is_noted_solid(item)) add_if_inside(*this, geometry, 0, item, point, found);
    return found;
}

Passing World::pass(PrimitiveIndex primitive, EnteredSolids& inside) const {
    const auto at = std::ranges::find(inside, solid(primitive),
                                      [&](PrimitiveIndex each) { return solid(each); });
    if (at == inside.end()) {
        inside.push_back(primitive);
        return Passing::enters;
    }
    const bool innermost = at + 1 == inside.end();
    inside.erase(at);
    return innermost ? Passing::leaves_innermost : Passing::leaves_outer;
}

std::uint32_t World::solid(PrimitiveIndex primitive) const {
    constexpr std::uint32_t above_all = 0x80000000;
    if (const std::uint32_t number = material(primitive).shared_interior) return above_all - number;
    if (geometry.is_leaf(primitive)) return geometry.item_of(primitive);
    if (geometry.is_instanced(primitive)) {
        const Instance& placed = geometry.instance_of(primitive);
        const Prototype& prototype = geometry.prototype_of(placed);
        const Geometry& own = prototype.geometry;
        const PrimitiveIndex here = primitive - placed.first;
        if (own.is_leaf(here)) return placed.first + own.composite(own.item_of(here))->first_leaf;
        return own.is_triangle(here) ? placed.first + prototype.first_of_solid(here) : primitive;
    }
    return geometry.is_triangle(primitive) ? ~material(primitive).solid : primitive;
}

}  // namespace candelabra
