// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/dump.h"

#include "formula/function_texts.h"
#include "scene/dump_function.h"
#include "scene/dump_texture.h"
#include "shape/text_turn.h"
#include "text/message.h"
#include "vocabulary/written.h"

#include <array>
#include <memory>
#include <unordered_map>
#include <utility>

namespace candelabra {

namespace {

/// Objects nested more deeply are declared separately, which keeps the text readable and bounds the
/// recursion.
constexpr int deepest = 16;

/// Without a `background`, rays to infinity see black, which is transparent in a picture with
/// alpha.
const Colour no_background{Rgb(0), 0, 1};

template <class T>
std::string block_text(const T& item) {
    const std::string fields = written_fields(T::vocabulary, &item);
    return message(T::vocabulary.name, " { ", fields, fields.empty() ? "" : " ", "}");
}

std::string media_text(const Media& media) {
    std::string text = message("media { ", written_fields(Media::vocabulary, &media));
    if (media.scatters())
        text += message(" scattering { ", written_fields(Scattering::vocabulary, &media.scattering),
                        " }");
    for (const Pigment& density : media.densities)
        text += message(" density", dump(density).substr(std::string_view("pigment").size()));
    return text + " }";
}

std::string interior_text(const Interior& interior) {
    std::string text = message("interior { ", written_fields(Interior::vocabulary, &interior));
    for (const Media& media : interior.media) text += " " + media_text(media);
    return text + " }";
}

std::string settings_text(const Scene& scene) {
    GlobalSettings settings = scene.settings;
    const bool srgb = settings.assumed_gamma < 0;
    if (srgb) settings.assumed_gamma = GlobalSettings().assumed_gamma;
    std::string text = written_fields(GlobalSettings::vocabulary, &settings);
    if (srgb) text += message(text.empty() ? "" : " ", "assumed_gamma srgb");
    // Before version 3.7, an explicit default has an effect.
    if (scene.gamma_handling && scene.language_version < 3.7 && settings.assumed_gamma == 1 &&
        !srgb)
        text += message(text.empty() ? "" : " ", "assumed_gamma 1");
    const auto luminaires = [&](auto... rule) {
        text += message(text.empty() ? "" : " ", "luminaires ", rule...);
    };
    if (settings.ambient_luminaires) luminaires("ambient");
    if (std::isinf(settings.luminaires_above))
        luminaires("none");
    else if (settings.luminaires_above > 0)
        luminaires("above ", settings.luminaires_above);
    else if (settings.luminaires_said && !settings.ambient_luminaires)
        luminaires("emission");
    if (settings.photometry != PhotometricUnits())
        text += message(text.empty() ? "" : " ", "photometry { ",
                        written_fields(PhotometricUnits::vocabulary, &settings.photometry), " }");
    if (settings.subsurface.on) {
        const std::string fields =
            written_fields(SubsurfaceSettings::vocabulary, &settings.subsurface);
        text += message(text.empty() ? "" : " ", "subsurface {", fields.empty() ? "" : " ", fields,
                        " }");
    }
    if (settings.radiosity.on) {
        const std::string fields = written_fields(Radiosity::vocabulary, &settings.radiosity);
        text += message(text.empty() ? "" : " ", "radiosity {", fields.empty() ? "" : " ", fields,
                        " }");
    }
    if (settings.photons.on) {
        const std::string fields = written_fields(PhotonSettings::vocabulary, &settings.photons);
        text +=
            message(text.empty() ? "" : " ", "photons {", fields.empty() ? "" : " ", fields, " }");
    }
    const std::string sampler = item_text(settings.light_sampler);
    if (sampler != item_text(GlobalSettings().light_sampler))
        text += message(text.empty() ? "" : " ", "light_sampler { ", sampler, " }");
    const std::string index = item_text(settings.index);
    if (index != item_text(GlobalSettings().index))
        text += message(text.empty() ? "" : " ", "index { ", index, " }");
    const std::string integrator = item_text(settings.integrator);
    if (integrator != item_text(GlobalSettings().integrator))
        text += message(text.empty() ? "" : " ", "integrator { ", integrator, " }");
    return text.empty() ? "" : message("global_settings { ", text, " }\n");
}

/// The first version with other default textures and cameras than those of the structs.
constexpr double first_modern = 3.8;

/// The camera with its default width stated, where that depends on the size of the picture or would
/// be another one for the version.
Camera with_stated_width(Camera camera, double version) {
    const bool parallel = std::holds_alternative<Orthographic>(camera);
    View& view = std::visit([](auto& c) -> View& { return c; }, camera);
    if (view.right || (version < first_modern && view.aspect == View().aspect)) return camera;
    double size = 1;
    if (parallel && !view.up && !view.angle) {  // as wide as look_at is far away
        const Vec3 ahead = view.look_at.value_or(Vec3(0, 0, 1)) - view.location;
        size = length(ahead) / length(view.direction.value_or(Vec3(0, 0, 1)));
        view.up = Vec3(0, size, 0);
    }
    view.right = Vec3(size * view.aspect, 0, 0);
    return camera;
}

/// The shape of the lens; empty for a round one.
std::string bokeh_text(const Scene& scene) {
    const Bokeh& bokeh = std::visit([](const View& view) { return view.bokeh; }, scene.camera);
    const Bokeh usual;
    if (!scene.bokeh && bokeh.blades == usual.blades && bokeh.angle == usual.angle) return {};
    return message(" bokeh { ", written_fields(Bokeh::vocabulary, &bokeh),
                   scene.bokeh ? dump(*scene.bokeh) : std::string(), " }");
}

std::string user_rays_text(const Camera& camera) {
    const auto* user = std::get_if<UserDefinedCamera>(&camera);
    if (!user) return {};
    const auto block = [](std::string_view word, const CameraFunctions& functions) {
        if (!functions.given()) return std::string();
        return message(' ', word, " { ", written_fields(CameraFunctions::vocabulary, &functions),
                       " }");
    };
    return block("location", user->from) + block("direction", user->towards);
}

std::string camera_text(const Scene& scene) {
    const Camera camera = with_stated_width(scene.camera, scene.language_version);
    const Transform& transform =
        std::visit([](const View& view) -> const Transform& { return view.transform; }, camera);
    return message("camera { ", item_text(camera), user_rays_text(camera),
                   dump(scene.camera_normal), scene.film.on ? " " : "", film_text(scene.film),
                   bokeh_text(scene), matrix_text(transform), " }\n");
}

/// Writes the light without its `looks_like`, which is an object of its own.
std::string light_text(PlacedLight placed) {
    const ItemInfo& info = PointLight::vocabulary;
    std::string text = message(info.name, " { ", written_fields(info, &placed.light));
    if (placed.projected_through)
        text += message(" projected_through { ", in_one_line(*placed.projected_through), " }");
    const std::string photons = written_fields(LightPhotons::vocabulary, &placed.photons);
    if (!photons.empty()) text += message(" photons { ", photons, " }");
    return text + " }\n";
}

std::string lights_text(const Scene& scene) {
    std::string text;
    for (const PlacedLight& light : scene.lights) text += light_text(light);
    return text;
}

std::string background_text(const Scene& scene) {
    const Colour& colour = scene.background.colour;
    if (colour == no_background) return {};
    return message("background { ", colour_text(colour), " }\n");
}

std::string sky_text(const Scene& scene) { return scene.sky ? dump(*scene.sky) : std::string(); }

std::string daylight_text(const Scene& scene) {
    return scene.daylight ? block_text(*scene.daylight) + "\n" : std::string();
}

std::string fogs_text(const Scene& scene) {
    std::string text;
    for (const Fog& fog : scene.fogs) text += block_text(fog) + "\n";
    return text;
}

std::string media_of_scene_text(const Scene& scene) {
    std::string text;
    for (const Media& media : scene.media) text += media_text(media) + "\n";
    return text;
}

std::string rainbows_text(const Scene& scene) {
    std::string text;
    for (const Rainbow& rainbow : scene.rainbows) text += dump(rainbow);
    return text;
}

std::string meters_text(const Scene& scene) {
    std::string text;
    for (const Meter& meter : scene.meters) text += block_text(meter) + "\n";
    return text;
}

constexpr std::string_view settings_block = "global_settings";

constexpr auto blocks_of_scenes = std::to_array<SceneText>({
    {settings_block, settings_text},
    {"background", background_text},
    {"sky_sphere", sky_text},
    {"sky_luminance", daylight_text},
    {"fog", fogs_text},
    {"rainbow", rainbows_text},
    {"media", media_of_scene_text},
    {"meter", meters_text},
    {"camera", camera_text},
    {"light_source", lights_text},
});

std::string clipping_text(std::string_view word, const std::vector<ObjectHandle>& objects) {
    std::string text = message(word, " { ");
    for (const ObjectHandle& each : objects) text += in_one_line(*each) + " ";
    return text + "}";
}

/// Writes the textures that the faces of a mesh refer to by number.
std::string list_text(const std::vector<Handle<Texture>>& list) {
    std::string text = message("texture_list { ", list.size());
    for (const Handle<Texture>& each : list) text += ", " + dump(*each);
    return text + " }";
}

/// The function or file comes first. It is not among the fields then, where each kind of file has a
/// word.
std::string heights_text(HeightField field) {
    const std::string source = field.function ? written(field.function, FieldType::function)
                                              : message(field.kind, field.kind.empty() ? "" : " ",
                                                        written(field.file, FieldType::text));
    field.function = nullptr;
    field.file.clear();
    const std::string fields = written_fields(HeightField::vocabulary, &field);
    return message(source, fields.empty() ? "" : " ", fields);
}

bool is_mesh(const Object& object) {
    const auto* shape = std::get_if<Shape>(&object.form);
    return shape && std::holds_alternative<Shared<Mesh>>(*shape);
}

/// The transformation that is written: `text { }` has its turn without saying so.
Transform said_transform(const Object& object) {
    const Transform all = object.transform ? *object.transform : Transform();
    const auto* shape = std::get_if<Shape>(&object.form);
    if (!shape || !std::holds_alternative<Shared<Text>>(*shape)) return all;
    return all == text_turn() ? Transform() : text_turn().inverse().then(all);
}

/// Writes the texture of a part. The object's transformation follows it and will be applied to it,
/// so its inverse is applied here.
std::string part_look(const Object& object, int number) {
    const Texture& texture = *object.part_textures->list[static_cast<std::size_t>(number)];
    return " " + dump(object.transform ? transformed(texture, said_transform(object).inverse())
                                       : texture);
}

/// The modifiers that follow an object's own content. The texture comes last, because a
/// transformation before it does not move it.
std::vector<std::string> modifiers_of(const Object& object) {
    std::vector<std::string> result;
    if (const Transform moved = said_transform(object); !(moved == Transform()))
        result.push_back(matrix_text(moved).substr(1));
    if (object.clipping && !object.clipping->clips.empty())
        result.push_back(clipping_text("clipped_by", object.clipping->clips));
    if (object.clipping && !object.clipping->bounds.empty())
        result.push_back(clipping_text("bounded_by", object.clipping->bounds));
    for (std::size_t i = 0; i < Switches::vocabulary.fields.size(); ++i)
        if (std::get<double>(Switches::vocabulary.get(&object.switches(), i)) != 0)
            result.emplace_back(Switches::vocabulary.fields[i].name);
    if (const auto* together = std::get_if<Union>(&object.form); together && together->light_name)
        result.push_back(message("light_name ", written(*together->light_name, FieldType::text)));
    if (object.photons) result.push_back(block_text(*object.photons));
    if (object.lamp) result.push_back(block_text(*object.lamp));
    if (object.part_textures && !object.part_textures->list.empty() && is_mesh(object))
        result.push_back(list_text(object.part_textures->list));
    if (object.part_textures && object.part_textures->interior)
        result.push_back("interior_" + dump(*object.part_textures->interior));
    if (object.interior) result.push_back(interior_text(*object.interior));
    if (object.texture) result.push_back(dump(*object.texture));
    return result;
}

std::span<const ObjectHandle> children(const Object& object) {
    const auto* together = std::get_if<Union>(&object.form);
    return together ? std::span<const ObjectHandle>(together->children)
                    : std::span<const ObjectHandle>();
}

bool is_row(const Object& object) { return std::holds_alternative<SphereRow>(object.form); }

bool is_group(const Object& object) {
    const auto* together = std::get_if<Union>(&object.form);
    return together && together->light_group;
}

/// Whether only a light is left of the object; lights in unions are written separately.
bool is_only_light(const Object& object) {
    const Object* inner = &object;
    while (children(*inner).size() == 1 && !is_group(*inner)) inner = children(*inner)[0].get();
    const auto* together = std::get_if<Union>(&inner->form);
    return together && together->lamp && together->children.empty();
}

/// The object inside unions that only wrap it: a copy of a declared union is read as a union of
/// this kind.
const Object& essence(const Object& object) {
    const Object* result = &object;
    while (children(*result).size() == 1 && modifiers_of(*result).empty() && !is_group(*result) &&
           !is_row(*children(*result).front()))
        result = children(*result).front().get();
    return *result;
}

/// Lists every object below the roots once, children before parents. Iterative, since unions may be
/// nested very deeply.
std::vector<const Object*> in_order(std::span<const ObjectHandle> roots,
                                    std::unordered_map<const Object*, int>& references) {
    struct Step {
        const Object* object;
        std::span<const ObjectHandle> rest;
    };
    std::vector<const Object*> order;
    std::vector<Step> path = {{nullptr, roots}};
    while (!path.empty()) {
        if (path.back().rest.empty()) {
            if (path.back().object) order.push_back(path.back().object);
            path.pop_back();
            continue;
        }
        const Object* next = &essence(*path.back().rest.front());
        path.back().rest = path.back().rest.subspan(1);
        if (references[next]++ == 0) path.push_back({next, children(*next)});
    }
    return order;
}

std::string_view keyword(Csg csg) {
    switch (csg) {
        case Csg::together:
            return "union";
        case Csg::intersection:
            return "intersection";
        case Csg::difference:
            return "difference";
        case Csg::merge:
            break;
    }
    return "merge";
}

class Dumper {
public:
    std::string line(const Object& object) {
        write(object, 0);
        std::string result;
        for (const char c : out_)
            if (c != '\n')
                result += c;
            else if (result.back() != ' ')
                result += ' ';
        result.pop_back();
        return result;
    }

    std::string text(const Scene& scene) {
        out_ = message("#version ", scene.language_version, ";\n");
        if (scene.language_version >= first_modern)
            out_ += "#default { pigment { rgb 0 } finish { ambient 0.1 } }\n";
        // Functions of colours depend on the settings.
        out_ += settings_text(scene);
        const std::string head = std::exchange(out_, {});
        for (const SceneText& each : scene_texts())
            if (each.word != settings_block) out_ += each.text(scene);
        declare_shared(scene.objects);
        for (const ObjectHandle& object : scene.objects)
            if (!is_only_light(*object)) refer(*object, 0);
        FunctionWriter functions;
        const std::string rest = functions.replaced(out_);
        return head + functions.declarations() + rest;
    }

private:
    void declare_shared(std::span<const ObjectHandle> roots) {
        std::unordered_map<const Object*, int> references, heights;
        for (const Object* object : in_order(roots, references)) {
            int height = 0;
            for (const ObjectHandle& child : children(*object))
                height = std::max(height, heights[&essence(*child)] + 1);
            const bool apart = references[object] > 1 || height >= deepest;
            heights[object] = apart ? 0 : height;
            if (!apart || is_only_light(*object)) continue;
            std::string name = message("Object_", names_.size() + 1);
            out_ += message("#declare ", name, " = ");
            if (is_row(*object)) out_ += "union {\n";
            write(*object, is_row(*object) ? 1 : 0);
            if (is_row(*object)) out_ += "}\n";
            names_.emplace(object, std::move(name));
        }
    }

    void refer(const Object& referred, std::size_t depth) {
        const Object& object = essence(referred);
        const auto name = names_.find(&object);
        if (name == names_.end()) return write(object, depth);
        out_.append(4 * depth, ' ');
        out_ += message("object { ", name->second, " }\n");
    }

    /// Writes a row as individual spheres.
    void write(const Object& object, std::size_t depth) {
        if (const auto* shape = std::get_if<Shape>(&object.form))
            return write(*shape, object, depth);
        if (const auto* row = std::get_if<SphereRow>(&object.form)) {
            for (const Sphere& sphere : row->spheres) write(sphere, object, depth);
            return;
        }
        out_.append(4 * depth, ' ');
        const Union& group = std::get<Union>(object.form);
        out_ += message(group.light_group ? "light_group" : keyword(group.csg), " {\n");
        if (group.light_group) write_lights(group, depth + 1);
        for (const ObjectHandle& child : children(object))
            if (!is_only_light(*child)) refer(*child, depth + 1);
        for (const std::string& each : modifiers_of(object))
            out_ += std::string(4 * depth + 4, ' ') + each + "\n";
        out_ += std::string(4 * depth, ' ') + "}\n";
    }

    void write_lights(const Union& group, std::size_t depth) {
        for (const PlacedLight& light : group.lights)
            out_ += std::string(4 * depth, ' ') + light_text(light);
        if (group.global_lights) out_ += std::string(4 * depth, ' ') + "global_lights\n";
    }

    void write(Shape shape, const Object& object, std::size_t depth) {
        const ItemInfo& info = *Kinds<Shape>::infos[shape.index()];
        out_.append(4 * depth, ' ');
        const auto look = [&](int number) { return part_look(object, number); };
        const auto* heights = std::get_if<Shared<HeightField>>(&shape);
        out_ += message(info.name, " { ",
                        heights ? heights_text(**heights)
                                : written_fields(info, Kinds<Shape>::address(shape), look));
        for (const std::string& each : modifiers_of(object)) out_ += " " + each;
        out_ += " }\n";
    }

    std::string out_;
    std::unordered_map<const Object*, std::string> names_;
};

}  // namespace

std::string in_one_line(const Object& object) { return Dumper().line(object); }

std::string film_text(const FilmSettings& film) {
    if (!film.on) return {};
    std::string text = written_fields(FilmSettings::vocabulary, &film);
    if (film.glares) text += message(text.empty() ? "" : " ", block_text(film.glare));
    return message("film { ", text, text.empty() ? "" : " ", "}");
}

std::span<const SceneText> scene_texts() { return blocks_of_scenes; }

WrittenFunctions::WrittenFunctions() : texts_(std::make_unique<FunctionTexts>()) {}
WrittenFunctions::~WrittenFunctions() = default;

std::string dump(const Scene& scene) { return Dumper().text(scene); }

}  // namespace candelabra
