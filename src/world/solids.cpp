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

/// Adds the noted solids of an instance that contain the point, each by its first primitive.
void add_those_inside(const World& world, const Instance& placed, const Vec3& point,
                      EnteredSolids& found) {
    const Geometry& geometry = world.geometry.prototype_of(placed).geometry;
    const Vec3 here = placed.place->inverse_point(point);
    for (std::uint32_t item = 0; item < geometry.item_count(); ++item) {
        if (geometry.is_triangle(item) || !contains(geometry.noticed_in(item), here)) continue;
        const PlacedComposite* whole = geometry.composite(item);
        const PrimitiveIndex first = placed.first + (whole ? whole->first_leaf : item);
        if (keeps_out(world, world.material(first)) && is_within(geometry, item, here))
            found.push_back(first);
    }
}

/// Adds a noted solid if it contains the point; a composite by the leaf whose interior applies.
void add_if_inside(const World& world, std::uint32_t item, const Vec3& point,
                   EnteredSolids& found) {
    if (!contains(world.geometry.noticed_in(item), point)) return;
    if (const Instance* instance = world.geometry.instance(item))
        return add_those_inside(world, *instance, point, found);
    const PlacedComposite* placed = world.geometry.composite(item);
    if (!placed) {
        if (world.contains_point(item, point)) found.push_back(item);
        return;
    }
    if (!placed->composite->inside(point)) return;
    // The solid's interior is the one behind its first transparent leaf.
    PrimitiveIndex leaf = placed->first_leaf;
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

bool World::is_noted_solid(std::uint32_t item) const {
    if (geometry.is_triangle(item)) return false;
    if (geometry.instance(item)) return facts.dims_between;
    const PlacedComposite* placed = geometry.composite(item);
    const Material& outer = material(placed ? placed->first_leaf : item);
    // An opaque solid may contain the camera, or have holes through which its inside is seen.
    return keeps_out(*this, outer) || outer.interior ||
           (placed ? placed->transparent : outer.transparent);
}

EnteredSolids World::containing(const Vec3& point) const {
    EnteredSolids found;
    if (!facts.notes_solids) return found;
    if (facts.indexes_solids) {
        for (const std::uint32_t item : geometry.clear_solids.infinite)
            add_if_inside(*this, item, point, found);
        geometry.clear_solids.index.around(point, [&](std::uint32_t part) {
            add_if_inside(*this, geometry.clear_solids.finite[part], point, found);
        });
        return found;
    }
    for (std::uint32_t item = 0; item < geometry.item_count(); ++item)
        if (is_noted_solid(item)) add_if_inside(*this, item, point, found);
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
        const Geometry& own = geometry.prototype_of(placed).geometry;
        const PrimitiveIndex here = primitive - placed.first;
        if (own.is_leaf(here)) return placed.first + own.composite(own.item_of(here))->first_leaf;
        return own.is_triangle(here) ? ~material(primitive).solid : primitive;
    }
    return geometry.is_triangle(primitive) ? ~material(primitive).solid : primitive;
}

}  // namespace candelabra
