// SPDX-License-Identifier: GPL-3.0-or-later
#include "csg/extent.h"

#include "base/long_work.h"
#include "csg/shape_extent.h"
#include "shape/built_shape.h"
#include "shape/transformed.h"

namespace candelabra {

namespace {

double volume(const Box& box) {
    const Vec3 size = glm::max(box.size(), Vec3(0));
    return size.x * size.y * size.z;
}

/// Box of the intersection of all objects. As in POV-Ray, inverse ones have no end.
Box shared(const std::vector<ObjectHandle>& objects) {
    Box result = everywhere();
    for (const ObjectHandle& each : objects)
        if (!each->inverse) result = clip(result, extent(*each));
    return result;
}

Box clipped(const Box& box, const Clipping& clipping) {
    Box result = box;
    for (const auto* objects : {&clipping.clips, &clipping.bounds}) {
        const Box other = shared(*objects);
        if (!objects->empty() && volume(other) < volume(result)) result = other;
    }
    return result;
}

/// The half space of a plane if the object is one, otherwise an upper bound of its part in an
/// intersection.
Box cutting(const Object& object, bool inverse) {
    const auto* shape = std::get_if<Shape>(&object.form);
    const Plane* plane = shape ? std::get_if<Plane>(shape) : nullptr;
    if (!plane) return inverse != object.inverse ? everywhere() : extent(object);
    Plane placed = *plane;
    if (object.transform) placed = transformed(*plane, *object.transform);
    if (inverse != object.inverse) placed = {-placed.normal, -placed.distance};
    return inside_bounds(placed);
}

Box extent_of(const Union& group) {
    if (!group.lights.empty()) return everywhere();
    if (group.csg == Csg::together || group.csg == Csg::merge) {
        Box box;
        for (const ObjectHandle& child : group.children) box = join(box, extent(*child));
        return box.empty() ? everywhere() : box;
    }
    Box box = everywhere();
    for (const ObjectHandle& child : group.children) {
        const bool taken_away = group.csg == Csg::difference && &child != &group.children.front();
        box = clip(box, cutting(*child, taken_away));
    }
    return box;
}

Box extent_of(const SphereRow& row) {
    Box box;
    count_long_work(row.spheres.size());
    for (const Sphere& sphere : row.spheres) box = join(box, bounds(sphere));
    return box;
}
}  // namespace

Box own_extent(const Object& object) {
    if (const auto* shape = std::get_if<Shape>(&object.form)) return shape_extent(*shape, nullptr);
    if (const auto* row = std::get_if<SphereRow>(&object.form)) return extent_of(*row);
    return extent_of(std::get<Union>(object.form));
}

Box extent(const Object& object) {
    constexpr std::uint32_t work_of_part = 3;
    count_work(work_of_part);
    Box box;
    if (const auto* shape = std::get_if<Shape>(&object.form)) {
        box = shape_extent(*shape, object.transform ? &*object.transform : nullptr);
    } else {
        box = own_extent(object);
        if (object.transform) box = object.transform->box(box);
    }
    if (object.clipping) box = clipped(box, *object.clipping);
    return {glm::clamp(box.low, -no_end, no_end), glm::clamp(box.high, -no_end, no_end)};
}

Box bounds_of_inside(const Object& object) {
    const auto* shape = std::get_if<Shape>(&object.form);
    const bool plane = shape && std::holds_alternative<Plane>(*shape);
    return plane ? everywhere() : extent(object);
}

bool has_needless_bounds(const Object& object) {
    if (!object.clipping || object.clipping->bounds.empty()) return false;
    if (const auto* shape = std::get_if<Shape>(&object.form))
        return !(std::holds_alternative<Shared<Cubic>>(*shape) ||
                 std::holds_alternative<Shared<Quartic>>(*shape) ||
                 std::holds_alternative<Shared<Poly>>(*shape) ||
                 std::holds_alternative<Shared<Polynomial>>(*shape));
    const auto* group = std::get_if<Union>(&object.form);
    if (!group || group->csg != Csg::together || !object.clipping->clips.empty()) return false;
    Box box = own_extent(object);
    if (object.transform) box = object.transform->box(box);
    return finite(box) && volume(box) < no_end &&
           volume(box) <= volume(shared(object.clipping->bounds));
}

Object without_bounds(const Object& object) {
    Object free = object;
    if (object.clipping->clips.empty())
        free.clipping = nullptr;
    else
        free.clipping.edit().bounds.clear();
    return free;
}

}  // namespace candelabra
