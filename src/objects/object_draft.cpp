// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/object_draft.h"

#include "shape/double_cone.h"
#include "shape/text_turn.h"
#include "text/message.h"
#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo GroupSettings::vocabulary = described<GroupSettings>([] {
    return schema<GroupSettings>(
        "light_group", "Lights and objects: the light sources light these objects only.",
        Field<GroupSettings>{"global_lights", &GroupSettings::global_lights, flag,
                             "light sources outside of the group light its objects as well"});
});

const ItemInfo UnionSettings::vocabulary = described<UnionSettings>([] {
    return schema<UnionSettings>(
        "union", "Objects and lights as one.",
        Field<UnionSettings>{"light_name", &UnionSettings::light_name, item,
                             "the name of its light in --layers lights"});
});

void ObjectDraft::take(const Object& from) {
    switches = from.switches();
    declared_switches = switches;
    if (from.texture) texture.replace(from.texture);
    textured = from.texture != nullptr;
    made.edit().interior = from.interior;
    if (from.clipping) clipping = *from.clipping;
    if (from.part_textures) part_textures = from.part_textures->list;
    interior_texture = from.part_textures ? from.part_textures->interior : nullptr;
    has_form = true;
}

void ObjectDraft::move(const Movement& next) {
    const auto then = [&] {
        return make_handle<Transform>(movement ? movement->then(next.transform) : next.transform);
    };
    if (!movement && next.kept)
        movement = next.kept;
    else if (next.constant && constant_movement)
        movement = binder.movements.made(next.constant, movement, then);
    else
        movement = then();
    constant_movement = constant_movement && next.constant;
    modified = true;
    for (auto* objects : {&clipping.clips, &clipping.bounds})
        for (ObjectHandle& each : *objects)
            each = candelabra::transformed(std::move(each), next.transform);
    if (const auto& interior = made->interior; interior && moves(*interior))
        made.edit().interior = make_handle<Interior>(transformed(*interior, next.transform));
    if (switches.uv_mapping) return;
    for (Handle<Texture>& each : part_textures)
        if (TextureDraft(each).movable())
            each = make_handle<Texture>(transformed(*each, next.transform));
    if (interior_texture && TextureDraft(interior_texture).movable())
        interior_texture = make_handle<Texture>(transformed(*interior_texture, next.transform));
    if (!textured || !texture.movable()) return;
    texture.replace(binder.moved_appearances.made(next.constant, texture.handle(), [&] {
        return make_handle<Texture>(transformed(texture.now(), next.transform));
    }));
}

void append_lights(const Object& object, std::vector<PlacedLight>& lights) {
    const auto* together = std::get_if<Union>(&object.form);
    if (!together) return;
    for (const PlacedLight& light :
         together->light_group ? together->free_lights : together->lights)
        lights.push_back(object.transform ? candelabra::transformed(light, *object.transform)
                                          : light);
}

void take_lights(const Object& part, Union& whole) {
    const auto* together = std::get_if<Union>(&part.form);
    const bool own = !whole.light_group || (together && together->lamp);
    append_lights(part, own ? whole.lights : whole.free_lights);
}

ObjectHandle ObjectDraft::finished(Span span) {
    if (declared && only_moved() && std::holds_alternative<Union>(declared->form)) {
        ObjectHandle whole = another(declared);
        whole.edit().span = span;
        whole.edit().transform = movement;
        return whole;
    }
    Object& object = made.edit();
    object.span = span;
    if (declared) {
        object.form = declared->form;
        if (auto* together = std::get_if<Union>(&object.form)) together->named = true;
        object.transform = declared->transform;
        object.depth = declared->depth;
    } else if (const auto* shape = std::get_if<Shape>(&object.form);
               shape && std::holds_alternative<Shared<Text>>(*shape) && !object.transform) {
        // A text in `object { }` has been rotated already.
        object.transform = make_handle<Transform>(text_turn());
    }
    if (movement)
        object.transform = object.transform
                               ? make_handle<Transform>(object.transform->then(*movement))
                               : std::move(movement);
    for (const auto* objects : {&clipping.clips, &clipping.bounds})
        for (const ObjectHandle& each : *objects) nest(object, *each);
    if (!clipping.clips.empty() || !clipping.bounds.empty())
        object.clipping = make_handle<Clipping>(std::move(clipping));
    if (!part_textures.empty() || interior_texture)
        object.part_textures = make_handle<PartTextures>(
            PartTextures{std::move(part_textures), std::move(interior_texture)});
    if (textured) object.texture = texture.shared(binder.textures);
    object.switches() = switches;
    return std::move(made);
}

void ObjectDraft::divide_form() {
    const auto* cone = std::get_if<Cone>(&std::get<Shape>(made->form));
    if (!cone || !is_crossed(*cone)) return;
    const std::vector<Cone> parts = uncrossed(*cone);
    Object& object = made.edit();
    if (parts.size() == 1) {
        object.form = Shape(parts.front());
        return;
    }
    Union both;
    for (const Cone& part : parts) {
        both.children.push_back(binder.pool.make());
        both.children.back().edit().form = Shape(part);
        nest(object, *both.children.back());
    }
    object.form = std::move(both);
}

void nest_rows(Object& whole) {
    for (const ObjectHandle& child : std::get<Union>(whole.form).children)
        if (std::holds_alternative<SphereRow>(child->form)) nest(whole, *child);
}

ObjectHandle another(const ObjectHandle& declared) {
    if (!std::holds_alternative<Union>(declared->form)) return declared;
    ObjectHandle whole = make_handle<Object>();
    Union& together = whole.edit().form.emplace<Union>();
    append_lights(*declared, together.lights);
    together.lamp = std::get<Union>(declared->form).lamp;
    together.named = true;
    nest(whole.edit(), *declared);
    together.children.push_back(declared);
    whole.edit().span = declared->span;
    return whole;
}

ObjectHandle as_part(const ObjectHandle& declared) {
    const auto* together = std::get_if<Union>(&declared->form);
    return together && together->light_group ? another(declared) : declared;
}

bool may_be_cut(OpenBlock& block, const Object& object) {
    const bool good = block.binder.evaluator.may_have_parts(object.parts, block.span);
    block.broken |= !good;
    return good;
}

ObjectHandle too_deep(Binder& binder, const Element& element) {
    binder.evaluator.report(
        error(Fault::recursion_limit, element.word_span,
              message("objects are nested more than ", binder.evaluator.limits().nesting, " deep"))
            .with_help("give the parts to one `union` instead of wrapping each "
                       "in the next; --limit-nesting allows more"));
    binder.evaluator.stop();
    return nullptr;
}

ObjectHandle as_object(PlacedLight light) {
    ObjectHandle whole = make_handle<Object>();
    whole.edit().span = light.span;
    Union& together = whole.edit().form.emplace<Union>();
    if (light.looks_like) {
        nest(whole.edit(), *light.looks_like);
        together.children.push_back(std::move(light.looks_like));
    }
    light.looks_like = nullptr;
    together.lamp = true;
    together.lights.push_back(std::move(light));
    return whole;
}

}  // namespace candelabra
