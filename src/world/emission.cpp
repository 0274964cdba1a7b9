// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/emission.h"

#include <algorithm>

namespace candelabra {

namespace {

bool emits_nothing(const Texture& texture) {
    return texture.finish.emission == Rgb(0) && !texture.choice && !texture.below;
}

}  // namespace

bool cannot_emit(const Object& object, const Handle<Texture>* inherited) {
    if (object.lamp || (object.interior && object.interior->luminaire)) return false;
    const Handle<Texture>* own = object.texture ? &object.texture : inherited;
    const auto none_emits = [&](const std::vector<ObjectHandle>& parts) {
        return std::ranges::all_of(
            parts, [&](const ObjectHandle& part) { return cannot_emit(*part, own); });
    };
    if (object.part_textures || (object.clipping && !none_emits(object.clipping->clips)))
        return false;
    if (const auto* group = std::get_if<Union>(&object.form))
        return group->lights.empty() && !group->children.empty() && none_emits(group->children);
    return own && emits_nothing(**own);
}

bool emits(const Object& object, const Handle<Texture>* inherited) {
    const Handle<Texture>* own = object.texture ? &object.texture : inherited;
    const auto glows = [](const Handle<Texture>& texture) {
        return greatest_emission(*texture) != Rgb(0);
    };
    const auto any_emits = [&](const std::vector<ObjectHandle>& parts) {
        return std::ranges::any_of(parts,
                                   [&](const ObjectHandle& part) { return emits(*part, own); });
    };
    if (object.part_textures &&
        (std::ranges::any_of(object.part_textures->list, glows) ||
         (object.part_textures->interior && glows(object.part_textures->interior))))
        return true;
    if (object.clipping && any_emits(object.clipping->clips)) return true;
    if (const auto* group = std::get_if<Union>(&object.form)) return any_emits(group->children);
    return own && glows(*own);
}

}  // namespace candelabra
