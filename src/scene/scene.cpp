// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene.h"

PlacedLight moved(PlacedLight placed, const Transform& transform) {
    std::visit([&](auto& light) { light = transformed(light, transform); }, placed.light);
    for (ObjectHandle* object : {&placed.looks_like, &placed.projected_through}) {
        if (!*object) continue;
        ObjectHandle whole = make_handle<Object>();
        whole.edit().no_shadow = (*object)->no_shadow;
        whole.edit().form.emplace<Union>().children.push_back(std::move(*object));
        whole.edit().span = placed.span;
        whole.edit().transform = make_handle<Transform>(transform);
        *object = std::move(whole);
    }
    return placed;
}
