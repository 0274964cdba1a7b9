// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/scene_content.h"

#include "objects/models.h"
#include "objects/object_draft.h"

namespace candelabra {

void SceneContent::add(ObjectHandle object) {
    append_lights(*object, scene.lights);
    const auto* together = std::get_if<Union>(&object->form);
    if (together && together->children.empty()) return;
    binder.evaluator.count_placed(object->parts, object->span);
    if (!object->texture) object.edit().texture = binder.default_texture;
    if (!joins(scene.objects, *object)) scene.objects.push_back(std::move(object));
}

void SceneContent::add(const PlacedLight& light) {
    scene.lights.push_back({light.light, light.span, nullptr, light.projected_through,
                            light.photons, light.light_name});
    if (light.looks_like) add(light.looks_like);
}

void SceneContent::add(const DeclaredCamera& camera, const Element& block) {
    if (scene.camera_given && block.word_span != camera_at_)
        binder.evaluator.report(warning(Fault::duplicate, block.word_span,
                                        "there is a camera before this one; the last one counts"));
    show(camera);
    scene.camera_given = true;
    camera_at_ = block.word_span;
}

void SceneContent::show(const DeclaredCamera& camera) {
    scene.camera = camera.camera;
    scene.camera_normal = camera.normal;
    scene.film = camera.film;
    scene.bokeh = camera.bokeh;
}

}  // namespace candelabra
