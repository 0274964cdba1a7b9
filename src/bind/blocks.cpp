// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/blocks.h"

#include "appearance/colour_maps.h"
#include "appearance/finishes.h"
#include "appearance/materials.h"
#include "appearance/media.h"
#include "appearance/normals.h"
#include "appearance/textures.h"
#include "bind/backdrops.h"
#include "bind/cameras.h"
#include "bind/meters.h"
#include "bind/scene_content.h"
#include "bind/settings.h"
#include "objects/lights.h"
#include "objects/objects.h"
#include "reading/item_block.h"
#include "reading/transforms.h"
#include "surface/normal_map.h"
#include "surface/pigment_map.h"

#include <array>

namespace candelabra {

namespace {

template <class T>
Value shared_value(std::optional<T> made) {
    return made ? Value(make_handle<T>(std::move(*made))) : Value(Absence::broken);
}

// ---- readers of several blocks

/// Applies the block to the last argument; returns false after a diagnostic.
template <class T>
using ReadPart = bool (*)(Binder&, const Element&, T&);

template <class T, ReadPart<T> read>
Value part(Binder& binder, const Element& element) {
    T made{};
    return read(binder, element, made) ? Value(make_handle<T>(std::move(made)))
                                       : Value(Absence::broken);
}

/// Reads a part of a texture, starting from that of the default texture.
template <class T, T Texture::*member, ReadPart<T> read>
Value texture_part(Binder& binder, const Element& element) {
    T made = binder.default_texture.get()->*member;
    return read(binder, element, made) ? Value(make_handle<T>(std::move(made)))
                                       : Value(Absence::broken);
}
template <class T, T Texture::*member, ReadPart<T> read>
void default_texture_part(Binder& binder, const Element& element) {
    TextureDraft draft(binder.default_texture);
    if (read(binder, element, draft.edit().*member))
        binder.default_texture = draft.shared(binder.textures);
}

template <class T>
void keep(std::optional<T>& place, T made) {
    place = std::move(made);
}
template <class T>
void keep(std::vector<T>& place, T made) {
    place.push_back(std::move(made));
}
/// Reads a part of the scene, which keeps the last one or all of them.
template <class T, auto member, ReadPart<T> read>
void scene_part(SceneContent& content, const Element& element) {
    T made{};
    if (read(content.binder, element, made)) keep(content.scene.*member, std::move(made));
}

// ---- readers of one block

void sky_in_scene(SceneContent& content, const Element& element) {
    scene_part<SkySphere, &Scene::sky, read_sky_sphere>(content, element);
    content.scene.sky_statement = element.word_span;
}

void daylight_in_scene(SceneContent& content, const Element& element) {
    scene_part<Daylight, &Scene::daylight, read_item<Daylight>>(content, element);
    content.scene.daylight_statement = element.word_span;
}

void object_in_scene(SceneContent& content, const Element& element) {
    auto object = read_object_into(content.scene.objects, content.binder.default_texture,
                                   content.binder, element);
    if (object && *object) content.add(std::move(*object));
}

Value object_value(Binder& binder, const Element& element) {
    ObjectHandle object = read_object(binder, element);
    return object ? Value(std::move(object)) : Value(Absence::broken);
}

void light_in_scene(SceneContent& content, const Element& element) {
    if (is_lamp(content.binder, element)) return object_in_scene(content, element);
    if (const auto light = read_light(content.binder, element)) content.add(*light);
}

Value light_value(Binder& binder, const Element& element) {
    return is_lamp(binder, element) ? object_value(binder, element)
                                    : shared_value(read_light(binder, element));
}

void camera_in_scene(SceneContent& content, const Element& element) {
    DeclaredCamera camera = content.binder.default_camera;
    if (read_camera(content.binder, element, camera)) content.add(camera, element);
}

Value camera_value(Binder& binder, const Element& element) {
    DeclaredCamera camera = binder.default_camera;
    return read_camera(binder, element, camera) ? Value(make_handle<DeclaredCamera>(camera))
                                                : Value(Absence::broken);
}

void default_camera(Binder& binder, const Element& element) {
    read_camera(binder, element, binder.default_camera);
}

void background_in_scene(SceneContent& content, const Element& element) {
    read_background(content.binder, element, content.scene.background);
}

void settings_in_scene(SceneContent& content, const Element& element) {
    read_global_settings(content.binder, element, content.scene.settings, content.given);
}

Value density_value(Binder& binder, const Element& element) {
    Pigment made;
    made.colour.rgb = Rgb(1);
    return read_density(binder, element, made) ? Value(make_handle<Pigment>(std::move(made)))
                                               : Value(Absence::broken);
}

Value texture_value(Binder& binder, const Element& element) {
    const Handle<Texture> made = read_layers(binder, {&element, 1});
    return made ? Value(made) : Value(Absence::broken);
}

void default_texture(Binder& binder, const Element& element) {
    TextureDraft draft(binder.default_texture);
    if (read_texture(binder, element, draft))
        binder.default_texture = draft.shared(binder.textures);
}

Value transform_value(Binder& binder, const Element& element) {
    return shared_value(read_transform(binder, element));
}

using BlockForm = BlockRow::Form;

constexpr BlockRow with_words_of(std::string_view like, BlockRow row) {
    row.like = like;
    return row;
}

/// All that can be moved.
constexpr std::string_view takes_moves =
    "object | texture pigment normal density material camera light_source "
    "sky_sphere rainbow fog media transform pattern";
/// All that takes a pattern.
constexpr std::string_view takes_patterns = "pigment | normal density texture";

constexpr auto table_of_blocks = std::to_array<BlockRow>({
    with_words_of("objects", {"union", "", BlockForm::combination, object_in_scene, object_value}),
    with_words_of("objects",
                  {"intersection", "", BlockForm::combination, object_in_scene, object_value}),
    with_words_of("objects",
                  {"difference", "", BlockForm::combination, object_in_scene, object_value}),
    with_words_of("objects", {"merge", "", BlockForm::combination, object_in_scene, object_value}),
    with_words_of("objects",
                  {"composite", "", BlockForm::combination, object_in_scene, object_value}),
    with_words_of("objects",
                  {"light_group", "", BlockForm::combination, object_in_scene, object_value}),
    with_words_of("objects", {"object", "", BlockForm::object, object_in_scene, object_value}),
    {"model", "| camera", BlockForm::object, object_in_scene, object_value},
    {"replace", "model"},
    {"light_source", "", BlockForm::object, light_in_scene, light_value},
    {"camera", "", BlockForm::block, camera_in_scene, camera_value, default_camera},
    {"background", "", BlockForm::block, background_in_scene},
    {"sky_sphere", "", BlockForm::block, sky_in_scene, part<SkySphere, read_sky_sphere>},
    {"sky_luminance", "", BlockForm::block, daylight_in_scene},
    {"fog", "", BlockForm::block, scene_part<Fog, &Scene::fogs, read_fog>, part<Fog, read_fog>},
    {"rainbow", "", BlockForm::block, scene_part<Rainbow, &Scene::rainbows, read_rainbow>,
     part<Rainbow, read_rainbow>},
    {"media", "interior", BlockForm::block, scene_part<Media, &Scene::media, read_media>,
     part<Media, read_media>},
    {"meter", "", BlockForm::block, scene_part<Meter, &Scene::meters, read_meter>},
    {"global_settings", "", BlockForm::block, settings_in_scene},
    {"light_sampler", "global_settings"},
    {"integrator", "global_settings"},
    {"index", "global_settings"},
    {"luminaires", "global_settings"},
    {"photometry", "global_settings"},
    {"radiosity", "global_settings"},
    {"subsurface", "finish global_settings"},

    {"texture", "object | material texture tiles tile2 material_map texture_list", BlockForm::block,
     nullptr, texture_value, default_texture},
    with_words_of("texture", {"interior_texture", "object | material", BlockForm::block}),
    {"material", "object", BlockForm::block, nullptr, part<DeclaredMaterial, read_material>},
    {"interior", "object | material", BlockForm::block, nullptr, part<Interior, read_interior>},
    {"luminaire", "finish object"},
    {"photons", "object light_source global_settings", BlockForm::block},
    {"scattering", "media", BlockForm::block},
    {"density", "media | density", BlockForm::block, nullptr, density_value},
    with_words_of("density", {"density_map", "density", BlockForm::word, nullptr,
                              part<PigmentMap, read_pigment_map>}),
    {"global_lights", "light_group"},
    {"cutaway_textures", "intersection difference"},
    with_words_of("objects", {"clipped_by", "object | bounded_by"}),
    with_words_of("objects", {"bounded_by", "object | clipped_by"}),
    {"inverse", "object | transform"},
    {"uv_mapping", "object | texture pigment normal density"},
    {"transform", takes_moves, BlockForm::word, nullptr, transform_value},
    {"translate", takes_moves},
    {"rotate", takes_moves},
    {"scale", takes_moves},
    {"matrix", takes_moves},

    {"pigment", "texture | object sky_sphere pigment bokeh", BlockForm::block, nullptr,
     texture_part<Pigment, &Texture::pigment, read_pigment>,
     default_texture_part<Pigment, &Texture::pigment, read_pigment>},
    {"normal", "texture | object camera normal", BlockForm::block, nullptr,
     texture_part<Bump, &Texture::normal, read_normal>,
     default_texture_part<Bump, &Texture::normal, read_normal>},
    {"finish", "texture | object", BlockForm::block, nullptr,
     texture_part<Finish, &Texture::finish, read_finish>,
     default_texture_part<Finish, &Texture::finish, read_finish>},
    with_words_of("texture", {"texture_map", "texture", BlockForm::word, nullptr,
                              part<TextureMap, read_texture_map>}),
    {"tiles", "texture"},
    {"tile2", "tiles"},
    {"material_map", "texture"},
    {"no_bump_scale", "normal texture |"},
    {"quick_color", "pigment | density"},
    {"quick_colour", "pigment | density"},
    {"color_map", "pigment | density rainbow", BlockForm::block, nullptr,
     part<ColourMap, read_colour_map>},
    {"colour_map", "pigment | density rainbow", BlockForm::block, nullptr,
     part<ColourMap, read_colour_map>},
    with_words_of("pigment", {"pigment_map", "pigment", BlockForm::word, nullptr,
                              part<PigmentMap, read_pigment_map>}),
    {"warp", takes_patterns},
    with_words_of("normal", {"normal_map", "normal", BlockForm::word, nullptr,
                             part<NormalMap, read_normal_map>}),
    {"slope_map", "normal", BlockForm::word, nullptr, part<SlopeMap, read_slope_map>},
    {"irid", "finish"},
    {"microfacet", "finish"},
    {"albedo", "finish"},
    {"reflection", "finish"},
    {"reflection_exponent", "finish"},
    {"mesh_camera", "camera"},
    {"location", "camera"},
    {"direction", "camera"},
    {"film", "camera"},
    {"glare", "film"},
    {"bokeh", "camera"},
    with_words_of("object", {"looks_like", "light_source"}),
    with_words_of("object", {"projected_through", "light_source"}),
});

constexpr BlockRow shape_row{"shape", "", BlockForm::object, object_in_scene, object_value};

}  // namespace

const BlockTable& block_table() {
    static const BlockTable table(table_of_blocks, shape_row, read_object);
    return table;
}

}  // namespace candelabra
