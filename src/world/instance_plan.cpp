// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/instance_plan.h"

#include "surface/any_finish.h"
#include "surface/texture.h"
#include "world/materials.h"

#include <algorithm>
#include <variant>
#include <vector>

namespace candelabra {

namespace {

/// Whether the object is made of parts only that have no part in anything but themselves: no media,
/// no light source, no photons, no stated flux.
bool is_plain(const Object& object) {
    if (object.lamp || object.photons || object.part_textures || object.clipping ||
        object.inverse || (object.interior && !object.interior->media.empty()))
        return false;
    if (object.texture && !InstancePlan::is_alike(*object.texture)) return false;
    // The normals of a smooth triangle have length 1 where it stands, and are interpolated there.
    const auto* shape = std::get_if<Shape>(&object.form);
    if (shape && std::holds_alternative<Shared<SmoothTriangle>>(*shape)) return false;
    const auto* group = std::get_if<Union>(&object.form);
    if (!group) return true;
    const bool shares_interior = object.interior && group->csg == Csg::together;
    return !shares_interior && !group->light_group && !group->light_name && group->lights.empty() &&
           group->free_lights.empty() &&
           std::ranges::all_of(group->children,
                               [](const ObjectHandle& child) { return is_plain(*child); });
}

}  // namespace

bool InstancePlan::is_alike(const Texture& texture) {
    return moves_with_object(texture) && !nesting(texture).by_axes &&
           !any_finish(texture, [](const Finish& finish) {
               return finish.lamp || finish.subsurface.translucency != Rgb(0);
           });
}

bool InstancePlan::is_alike(const Material& m) {
    return is_alike(*m.texture) && !(m.interior && !m.interior->media.empty()) && !m.inner &&
           !m.texture2 && !m.by_axes && m.shared_interior == 0;
}

bool InstancePlan::is_bare(const Inherited& outer) {
    const Hidden &said = outer.said, &heeded = outer.heeded;
    return !(outer.inner || outer.interior || outer.light_group != 0 || outer.lamp != 0 ||
             outer.no_luminaire || outer.double_illuminate || outer.hollow || outer.uv ||
             outer.of_several) &&
           !(said.no_shadow || said.no_image || said.no_reflection || said.no_radiosity) &&
           heeded.no_shadow && heeded.no_image && heeded.no_reflection &&
           outer.photons == PhotonSurface{} &&
           (!outer.texture || ((*outer.texture)->plain() && is_alike(**outer.texture)));
}

InstancePlan::InstancePlan(const Scene& scene, const InstanceLimits& limits) : limits_(limits) {
    const View& view =
        std::visit([](const auto& camera) -> const View& { return camera; }, scene.camera);
    if (view.shutter > 0 || scene.settings.photons.on) return;
    for (const ObjectHandle& object : scene.objects) count(*object);
    for (auto& [object, places] : places_)
        places.shared = places.count > 1 && object->parts <= limits.most_parts &&
                        places.count * object->parts >= limits.least_in_all && is_plain(*object);
}

void InstancePlan::count(const Object& object) {
    const auto* group = std::get_if<Union>(&object.form);
    if (!group || group->csg != Csg::together || object.parts < limits_.least_parts) return;
    // A declared union is the one part of each union that moves it.
    const bool moves_one = group->children.size() == 1;
    if (!moves_one && ++places_[&object].count > 1) return;
    for (const ObjectHandle& child : group->children) count(*child);
}

}  // namespace candelabra
