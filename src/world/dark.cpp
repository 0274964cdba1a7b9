// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/dark.h"

#include <algorithm>

namespace {

bool emits_nothing(const Texture& texture) {
    return texture.finish.emission == Vec3(0) && !texture.choice && !texture.below;
}

}  // namespace

bool surely_dark(const Object& object, const Handle<Texture>* inherited) {
    const Handle<Texture>* own = object.texture ? &object.texture : inherited;
    const auto all_dark = [&](const std::vector<ObjectHandle>& parts) {
        return std::ranges::all_of(
            parts, [&](const ObjectHandle& part) { return surely_dark(*part, own); });
    };
    if (object.part_textures || (object.clipping && !all_dark(object.clipping->clips)))
        return false;
    if (const auto* group = std::get_if<Union>(&object.form))
        return group->lights.empty() && !group->children.empty() && all_dark(group->children);
    return own && emits_nothing(**own);
}
