// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/object_draft.h"

#include "evaluate/lights.h"

void ObjectDraft::take(const Object& from) {
    switches = {from.no_shadow, from.no_image, from.no_reflection,
                from.hollow,    from.inverse,  from.double_illuminate};
    declared_switches = switches;
    if (from.texture) texture.replace(from.texture);
    textured = from.texture != nullptr;
    object.interior = from.interior;
    has_form = true;
}

void ObjectDraft::move(const Transform& transform) {
    movement = movement.then(transform);
    moved = modified = true;
    if (textured) texture.move(transform);
}

void append_lights(const Object& object, std::vector<PlacedLight>& lights) {
    const auto* together = std::get_if<Union>(&object.form);
    if (!together) return;
    for (const PlacedLight& light : together->lights)
        lights.push_back(object.transform ? ::moved(light, *object.transform) : light);
}

Object ObjectDraft::finished(TextureStore& textures, Span span) {
    if (declared && only_moved() && std::holds_alternative<Union>(declared->form)) {
        Object whole = another(declared);
        whole.span = span;
        if (moved) whole.transform = make_handle<Transform>(movement);
        return whole;
    }
    Object result = std::move(object);
    result.span = span;
    if (declared) {
        result.form = declared->form;
        result.transform = declared->transform;
    }
    if (moved)
        result.transform =
            make_handle<Transform>(result.transform ? result.transform->then(movement) : movement);
    if (textured) result.texture = texture.shared(textures);
    result.no_shadow = switches.no_shadow;
    result.no_image = switches.no_image;
    result.no_reflection = switches.no_reflection;
    result.hollow = switches.hollow;
    result.inverse = switches.inverse;
    result.double_illuminate = switches.double_illuminate;
    return result;
}

Object another(const ObjectHandle& declared) {
    if (!std::holds_alternative<Union>(declared->form)) return *declared;
    Object whole;
    Union together;
    append_lights(*declared, together.lights);
    together.children.push_back(declared);
    whole.form = std::move(together);
    whole.span = declared->span;
    return whole;
}

Object as_object(PlacedLight light) {
    Object object;
    object.span = light.span;
    object.form = Union{{}, {std::move(light)}};
    return object;
}
