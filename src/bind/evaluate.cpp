// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/evaluate.h"

#include "bind/backdrops.h"
#include "bind/cameras.h"
#include "bind/colour_maps.h"
#include "bind/lights.h"
#include "bind/materials.h"
#include "bind/normals.h"
#include "bind/object_draft.h"
#include "bind/object_functions.h"
#include "bind/objects.h"
#include "bind/patterns.h"
#include "bind/settings.h"
#include "bind/solid_queries.h"
#include "bind/transforms.h"
#include "surface/normal_map.h"
#include "surface/pigment_map.h"
#include "text/harmless.h"
#include "text/message.h"

#include <utility>

namespace {

class SceneReader {
public:
    SceneReader(Evaluator& evaluator, Scene& scene) : binder_{evaluator}, scene_(scene) {
        top_.ignored = "max_intersections";
        scene.background.colour.transmit = 1;  // until there is one
    }

    void take(const Element& element) {
        if (take_stray_setting(element)) return;
        if (element.kind == Element::Kind::block) return take_block(element);
        if (element.kind == Element::Kind::value) {
            const auto object = element.value.handle<Object>();
            const auto light = element.value.handle<PlacedLight>();
            if (object || light) binder_.evaluator.count_object(element.span);
            if (object) return add(another(object));
            if (light) return add_light(*light);
        }
        stray(element);
    }

    Value value(std::span<const Element> elements) {
        const Element& first = elements.front();
        if (first.word == "texture"_word) return textures(elements);
        if (elements.size() > 1) {
            binder_.evaluator.report(error(Fault::wrong_count, elements[1].span,
                                           "one value is wanted here, and this is a second"));
            return Absence::broken;
        }
        return one(first);
    }

    Handle<Formula> function(const Element& element) {
        return element.word == "pigment"_word ? pigment_function(element)
                                              : pattern_function(element);
    }

    void set_default(const Element& element) {
        const NameId word = element.kind == Element::Kind::block ? element.word : no_name;
        if (word == "camera"_word) {
            read_camera(binder_, element, binder_.default_camera);
            return;
        }
        TextureDraft draft(binder_.default_texture);
        bool good = true;
        if (word == "texture"_word)
            good = read_texture(binder_, element, draft);
        else if (word == "pigment"_word)
            good = read_pigment(binder_, element, draft.edit().pigment);
        else if (word == "normal"_word)
            good = read_normal(binder_, element, draft.edit().normal);
        else if (word == "finish"_word)
            good = read_finish(binder_, element, draft.edit().finish);
        else
            return stray_default(element);
        if (good) binder_.default_texture = draft.shared(binder_.textures);
    }

    /// After the last element.
    void finish(bool version_given) {
        if (!binder_.evaluator.stopped()) stray_settings_.finish();
        scene_.language_version = version_given ? binder_.evaluator.version() : 3.62;
        const SceneNoise& noise = *binder_.evaluator.noise();
        if (!noise.given) scene_.settings.noise_generator = static_cast<int>(noise.generator());
        scene_.gamma_handling = given_.gamma || scene_.language_version >= 3.7;
        if (!scene_.camera_given) show(binder_.default_camera);
    }

private:
    /// What functions of patterns know of the scene. They make waves of ten sources, whatever it
    /// says, as in POV-Ray.
    static PatternScene around(const SceneNoise& noise) {
        PatternScene result;
        result.noise_generator = noise.generator();
        return result;
    }

    Handle<Formula> pattern_function(const Element& element) {
        PatternDraft draft;
        if (!read_pattern(binder_, element, draft)) return nullptr;
        const auto code = [use = draft.use(), transform = draft.transform,
                           noise = binder_.evaluator.noise()](const double* in, double* out) {
            const Vec3 point = transform.inverse_point(Vec3(in[0], in[1], in[2]));
            out[0] = use.value(use.place(point), around(*noise));
            return true;
        };
        return make_handle<Formula>(3, 1, code);
    }

    /// red, green, blue, filter, transmit
    Handle<Formula> pigment_function(const Element& element) {
        Pigment pigment = binder_.default_texture->pigment;
        if (!read_pigment(binder_, element, pigment)) return nullptr;
        const auto code = [pigment, noise = binder_.evaluator.noise()](const double* in,
                                                                       double* out) {
            const Colour colour = evaluate(pigment, Vec3(in[0], in[1], in[2]), around(*noise));
            for (int i = 0; i < 3; ++i) out[i] = colour.rgb[i];
            out[3] = colour.filter;
            out[4] = colour.transmit;
            return true;
        };
        return make_handle<Formula>(3, 5, code);
    }

    /// The setting that old scenes have outside of global_settings, and its number.
    bool take_stray_setting(const Element& element) {
        const bool begins =
            element.kind == Element::Kind::word && element.word == "max_trace_level"_word;
        if (begins)
            binder_.evaluator.report(warning(Fault::deprecated, element.word_span,
                                             "`max_trace_level` belongs into `global_settings`")
                                         .with_help("global_settings { max_trace_level 5 }"));
        return (begins || stray_settings_.waiting()) && stray_settings_.take(element);
    }

    void take_block(const Element& element) {
        top_.resume();
        const bool light = element.word == "light_source"_word && !is_lamp(binder_, element);
        if (light || makes_object(element.word)) binder_.evaluator.count_object(element.word_span);
        if (light) {
            if (const auto light = read_light(binder_, element)) add_light(*light);
        } else if (makes_object(element.word)) {
            auto object =
                read_object_into(scene_.objects, binder_.default_texture, binder_, element);
            if (object && *object) add(std::move(*object));
        } else if (element.word == "camera"_word) {
            take_camera(element);
        } else if (element.word == "background"_word) {
            read_background(binder_, element, scene_.background);
        } else if (element.word == "sky_sphere"_word) {
            SkySphere sky;
            if (read_sky_sphere(binder_, element, sky)) scene_.sky = std::move(sky);
        } else if (element.word == "fog"_word) {
            Fog fog;
            if (read_fog(binder_, element, fog)) scene_.fogs.push_back(fog);
        } else if (element.word == "rainbow"_word) {
            Rainbow rainbow;
            if (read_rainbow(binder_, element, rainbow))
                scene_.rainbows.push_back(std::move(rainbow));
        } else if (element.word == "global_settings"_word) {
            read_global_settings(binder_, element, scene_.settings, given_);
        } else {
            stray(element);
        }
    }

    void add_light(const PlacedLight& light) {
        scene_.lights.push_back({light.light, light.span, nullptr, light.projected_through});
        if (light.looks_like) add(light.looks_like);
    }

    /// The default texture is the one in force at the end of the object's statement.
    void add(ObjectHandle object) {
        append_lights(*object, scene_.lights);
        const auto* together = std::get_if<Union>(&object->form);
        if (together && together->children.empty()) return;
        binder_.evaluator.count_placed(object->parts, object->span);
        if (!object->texture) object.edit().texture = binder_.default_texture;
        scene_.objects.push_back(std::move(object));
    }

    void take_camera(const Element& element) {
        DeclaredCamera camera = binder_.default_camera;
        if (!read_camera(binder_, element, camera)) return;
        if (scene_.camera_given)
            binder_.evaluator.report(
                warning(Fault::duplicate, element.word_span,
                        "there is a camera before this one; the last one counts"));
        show(camera);
        scene_.camera_given = true;
    }

    void show(const DeclaredCamera& camera) {
        scene_.camera = camera.camera;
        scene_.camera_normal = camera.normal;
    }

    Value textures(std::span<const Element> elements) {
        OpenBlock block(binder_, "texture", elements.front().word_span);
        TextureDraft result(binder_.default_texture);
        for (const Element& element : elements) {
            TextureDraft draft(binder_.default_texture);
            if (!read_texture(binder_, element, draft)) return Absence::broken;
            Handle<Texture> made = draft.shared(binder_.textures);
            if (&element == &elements.front())
                result.replace(std::move(made));
            else
                result.replace(layered(block, element.word_span, result.handle(), std::move(made)));
        }
        if (block.broken) return Absence::broken;
        return result.shared(binder_.textures);
    }

    Value one(const Element& element) {
        const NameId word = element.word;
        if (word == "light_source"_word && !is_lamp(binder_, element))
            return handle(read_light(binder_, element));
        if (makes_object(word)) {
            ObjectHandle object = read_object(binder_, element);
            return object ? Value(std::move(object)) : Value(Absence::broken);
        }
        if (word == "transform"_word) return handle(read_transform(binder_, element));
        if (word == "pigment"_word)
            return read_part(element, binder_.default_texture->pigment, read_pigment);
        if (word == "normal"_word)
            return read_part(element, binder_.default_texture->normal, read_normal);
        if (word == "finish"_word)
            return read_part(element, binder_.default_texture->finish, read_finish);
        if (word == "material"_word) return read_part(element, DeclaredMaterial{}, read_material);
        if (word == "texture_map"_word) return read_part(element, TextureMap{}, read_texture_map);
        if (word == "sky_sphere"_word) return read_part(element, SkySphere{}, read_sky_sphere);
        if (word == "fog"_word) return read_part(element, Fog{}, read_fog);
        if (word == "rainbow"_word) return read_part(element, Rainbow{}, read_rainbow);
        if (word == "interior"_word) return read_part(element, Interior{}, read_interior);
        if (word == "color_map"_word || word == "colour_map"_word)
            return read_part(element, ColourMap{}, read_colour_map);
        if (word == "pigment_map"_word) return read_part(element, PigmentMap{}, read_pigment_map);
        if (word == "normal_map"_word) return read_part(element, NormalMap{}, read_normal_map);
        if (word == "slope_map"_word) return read_part(element, SlopeMap{}, read_slope_map);
        if (word == "camera"_word) {
            DeclaredCamera declared = binder_.default_camera;
            return read_camera(binder_, element, declared) ? handle(std::optional(declared))
                                                           : Value(Absence::broken);
        }
        OpenBlock block(binder_, {}, element.word_span);
        block.refuse(element,
                     {"sphere", "union", "object", "texture", "pigment", "normal", "finish",
                      "interior", "transform", "camera", "color_map", "light_source"});
        return Absence::broken;
    }

    template <class T>
    static Value handle(std::optional<T> made) {
        return made ? Value(make_handle<T>(std::move(*made))) : Value(Absence::broken);
    }

    template <class T>
    Value read_part(const Element& element, T part, bool (*read)(Binder&, const Element&, T&)) {
        return read(binder_, element, part) ? handle(std::optional<T>(std::move(part)))
                                            : Value(Absence::broken);
    }

    /// What is neither an object nor anything else that makes a scene.
    void stray(const Element& element) {
        WordList words = {"union",      "object",          "camera",
                          "background", "global_settings", "light_source"};
        for (const ItemInfo* shape : Kinds<Shape>::infos) words.push_back(shape->name);
        top_.refuse(element, words);
        top_.broken = false;
    }

    void stray_default(const Element& element) {
        OpenBlock block(binder_, "#default", element.word_span);
        block.form = "{ texture { ... } }, or pigment, normal, finish, camera";
        block.refuse(element, {"texture", "pigment", "normal", "finish", "camera"});
    }

    Binder binder_;
    Scene& scene_;
    OpenBlock top_{binder_, {}, {}};
    GivenSettings given_;
    OpenBlock around_settings_{binder_, "global_settings", {}};
    ItemReader stray_settings_{around_settings_, GlobalSettings::vocabulary, &scene_.settings};
};

}  // namespace

Scene evaluate(SourceStore& sources, const Loader& loader, SourceId main,
               const EvaluateOptions& options, Diagnostics& diagnostics) {
    Scene scene;
    Names names;
    Evaluator evaluator(sources, loader, names, diagnostics, options.facts);
    SolidQueries objects;
    evaluator.add_functions(object_functions(), objects);
    evaluator.set_limits(options.limits);
    SceneReader reader(evaluator, scene);
    ElementHandlers handlers;
    handlers.top = [&](const Element& element) { reader.take(element); };
    handlers.value = [&](std::span<const Element> elements) { return reader.value(elements); };
    handlers.function = [&](const Element& element) { return reader.function(element); };
    handlers.set_default = [&](const Element& element) { reader.set_default(element); };
    handlers.takes_braces = takes_braces;
    handlers.print = [&](std::string_view text) {
        if (options.print) options.print(text);
    };
    evaluator.set_handlers(std::move(handlers));
    for (const auto& declared : options.declares)
        std::visit([&](const auto& content) { evaluator.declare(declared.first, Value(content)); },
                   declared.second);
    evaluator.run(main);
    reader.finish(evaluator.version_given());
    if (options.only.empty()) return scene;
    const Value* only = evaluator.find(names.find(options.only));
    ObjectHandle object = only ? only->handle<Object>() : nullptr;
    if (!object && !diagnostics.failed())
        diagnostics.add(error(Fault::unknown_name, {},
                              message("no object is declared as `", harmless(options.only), "`")));
    scene.objects.clear();
    if (object) scene.objects.push_back(std::move(object));
    return scene;
}
