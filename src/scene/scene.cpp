// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene.h"

namespace {

/// The object with its textures and what confines it, which a map of its own would not move.
ObjectHandle moved(ObjectHandle object, const Transform& transform) {
    if (object->texture || object->part_textures || object->confines) {
        ObjectHandle whole = make_handle<Object>();
        whole.edit().span = object->span;
        nest(whole.edit(), *object);
        whole.edit().form.emplace<Union>().children.push_back(std::move(object));
        object = std::move(whole);
    }
    Handle<Transform>& own = object.edit().transform;
    own = make_handle<Transform>(own ? own->then(transform) : transform);
    return object;
}

}  // namespace

PlacedLight moved(PlacedLight placed, const Transform& transform) {
    std::visit([&](auto& light) { light = transformed(light, transform); }, placed.light);
    for (ObjectHandle* object : {&placed.looks_like, &placed.projected_through})
        if (*object) *object = moved(std::move(*object), transform);
    return placed;
}
