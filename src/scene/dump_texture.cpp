// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/dump_texture.h"

#include "scene/dump.h"
#include "scene/dump_function.h"
#include "scene/pattern_object.h"
#include "surface/normal_map.h"
#include "surface/pigment_map.h"
#include "surface/texture_map.h"

namespace candelabra {

namespace {

/// The contents of a picture's braces, except the textures of a material_map.
std::string picture_text(Pattern pattern) {
    PictureMap& picture = *picture_of(pattern);
    std::string text = picture.function ? " " + written(picture.function, FieldType::function)
                                        : message(picture.kind.empty() ? "" : " ", picture.kind,
                                                  " ", written(picture.file, FieldType::text));
    const ItemInfo& info = *Kinds<Pattern>::infos[pattern.index()];
    // Otherwise the fields would contain the function in the place of the file.
    picture.function = nullptr;
    const bool srgb = picture.gamma < 0;
    if (srgb) picture.gamma = 0;
    const std::string fields = written_fields(info, Kinds<Pattern>::address(pattern));
    if (!fields.empty()) text += " " + fields;
    if (srgb) text += " gamma srgb";
    if (const auto* image = std::get_if<ImageMap>(&pattern))
        for (const ImageMap::Adjustment& each : image->adjustments)
            text += message(each.filter ? " filter " : " transmit ",
                            each.number < 0 ? "all " : message(each.number, ", "), each.amount);
    return text;
}

/// The data of an object pattern is always a PatternObject.
std::string object_text(const ObjectPattern& pattern) {
    return in_one_line(*static_cast<const PatternObject*>(pattern.inside.data.get())->object);
}

std::string pattern_text(const Pattern& pattern) {
    const std::string text = item_text(pattern);
    if (picture_of(pattern))
        return message(Kinds<Pattern>::infos[pattern.index()]->name, " {", picture_text(pattern),
                       " }");
    if (std::holds_alternative<Slope>(pattern))
        return message("slope {", text.substr(std::string_view("slope").size()), " }");
    if (const auto* function = std::get_if<FunctionPattern>(&pattern))
        return written(function->formula, FieldType::function);
    if (const auto* object = std::get_if<ObjectPattern>(&pattern))
        return message("object { ", object_text(*object), " }");
    if (const auto* grey = std::get_if<PigmentGrey>(&pattern)) {
        // The data of a pigment_pattern is always a Pigment.
        std::string inner = dump(*static_cast<const Pigment*>(grey->grey.data.get()));
        return message("pigment_pattern", inner.substr(std::string_view("pigment").size()));
    }
    return text;
}

std::string steps_text(const PatternUse& use) {
    std::string text;
    for (const WarpStep& step : use.steps)
        if (const auto* transform = std::get_if<Transform>(&step))
            text += matrix_text(*transform);
        else
            text += message(" warp { ", item_text(std::get<Warp>(step)), " }");
    return text;
}

std::string use_text(const PatternUse& use) {
    std::string text = pattern_text(use.pattern);
    // Omit values that the name of the pattern implies.
    PatternModifiers modifiers;
    Waveform wave;
    name_pattern(use.pattern, modifiers, wave);
    if (use.wave.index() != wave.index() || std::holds_alternative<PolyWave>(use.wave))
        text += " " + item_text(use.wave);
    const bool same_frequency = use.modifiers.frequency == modifiers.frequency;
    modifiers = use.modifiers;
    if (same_frequency) modifiers.frequency = PatternModifiers().frequency;
    const std::string fields = written_fields(PatternModifiers::vocabulary, &modifiers);
    text += message(fields.empty() ? "" : " ", fields);
    if (!same_frequency && use.modifiers.frequency == PatternModifiers().frequency)
        text += message(" frequency ", use.modifiers.frequency);
    return text + steps_text(use);
}

std::string colours_text(const ColourMap& map) {
    std::string text;
    for (const ColourStop& stop : map)
        text += message("[", stop.value, " ", colour_text(stop.colour), "] ");
    return message(" color_map { ", text, "}");
}

std::string map_text(const PatternUse& use, const ColourMap& map) {
    std::string text;
    if (std::holds_alternative<ImageMap>(use.pattern)) return text;
    if (choices(use.pattern) > 0) {
        for (const ColourStop& stop : map)
            text += message(text.empty() ? " " : ", ", colour_text(stop.colour));
        return text;
    }
    return colours_text(map);
}

std::string map_text(const PatternUse&, const PigmentMap& map) {
    std::string text;
    for (const PigmentStop& stop : map) {
        const std::string pigment = dump(stop.pigment);
        constexpr std::string_view start = "pigment { ", end = "}";
        text +=
            message("[", stop.value, " ",
                    pigment.substr(start.size(), pigment.size() - start.size() - end.size()), "] ");
    }
    return message(" pigment_map { ", text, "}");
}

std::string map_text(std::monostate) { return {}; }

std::string map_text(const SlopeMap& map) {
    std::string text;
    for (const SlopeStop& stop : map)
        text += message("[", stop.value, " <", stop.height, ", ", stop.slope, ">] ");
    return message(" slope_map { ", text, "}");
}

std::string map_text(const NormalMap& map) {
    std::string text;
    for (const NormalStop& stop : map) {
        const std::string normal = dump(stop.bump);
        constexpr std::string_view start = " normal { ", end = "}";
        text += message(
            "[", stop.value, " ",
            normal.empty() ? normal
                           : normal.substr(start.size(), normal.size() - start.size() - end.size()),
            "] ");
    }
    return message(" normal_map { ", text, "}");
}

std::string reflection_text(const Reflection& reflection) {
    const Reflection none;
    const std::string fields = written_fields(Reflection::vocabulary, &reflection);
    return fields == written_fields(Reflection::vocabulary, &none)
               ? ""
               : message("reflection { ", fields, " }");
}

std::string finish_text(const Finish& finish) {
    const std::string fields = written_fields(Finish::vocabulary, &finish);
    std::string text = fields;
    const auto add = [&](const std::string& block) {
        text += message(text.empty() || block.empty() ? "" : " ", block);
    };
    add(reflection_text(finish.reflection));
    if (finish.irid.amount != 0)
        add(message("irid { ", written_fields(Irid::vocabulary, &finish.irid), " }"));
    if (finish.lamp)
        add(message("luminaire { ", written_fields(LampData::vocabulary, finish.lamp.get()), " }"));
    if (finish.microfacet.on)
        add(message("microfacet { ", written_fields(Microfacet::vocabulary, &finish.microfacet),
                    " }"));
    if (finish.subsurface.translucency != Rgb(0))
        add(message("subsurface { ", written_fields(Subsurface::vocabulary, &finish.subsurface),
                    " }"));
    return text.empty() ? text : message(" finish { ", text, " }");
}

std::string layer_content(const Texture&);

/// The texture in an entry of a map, which has room for one layer: several are declared before.
std::string entry_text(const Texture& texture) {
    if (!texture.below) return layer_content(texture);
    return message(FunctionWriter::texture_begin, dump(texture), FunctionWriter::texture_end);
}

/// The contents of the braces of one layer.
std::string layer_content(const Texture& texture) {
    if (!texture.choice)
        return message(dump(texture.pigment), dump(texture.normal), finish_text(texture.finish));
    const PatternedTexture& choice = *texture.choice;
    std::string text = choice.uv ? "uv_mapping " : "";
    if (const auto* map = std::get_if<MaterialMap>(&choice.use.pattern)) {
        text += message("material_map {", picture_text(*map), " ");
        for (const TextureStop& stop : choice.map)
            text += message("texture { ", entry_text(*stop.texture), " } ");
        return message(text, "}", steps_text(choice.use), matrix_text(choice.transform));
    }
    text += message(use_text(choice.use), " texture_map { ");
    for (const TextureStop& stop : choice.map)
        text += message("[", stop.value, " ", entry_text(*stop.texture), "] ");
    return message(text, "}", matrix_text(choice.transform));
}

}  // namespace

std::string colour_text(const Colour& colour) { return written(colour, FieldType::colour); }

std::string dump(const Pigment& pigment) {
    const std::string quick =
        pigment.quick ? message(" quick_color ", colour_text(*pigment.quick)) : "";
    if (!pigment.pattern) return message("pigment { ", colour_text(pigment.colour), quick, " }");
    const PatternUse& use = pigment.pattern->use;
    return message(
        "pigment { ", pigment.uv ? "uv_mapping " : "", use_text(use),
        std::visit([&](const auto& map) { return map_text(use, map); }, pigment.pattern->map),
        quick, matrix_text(pigment.transform), " }");
}

std::string dump(const PatternUse& use, const Transform& transform) {
    return message("pattern { ", use_text(use), matrix_text(transform), " }");
}

std::string dump(const Bump& bump) {
    if (!bump.pattern) return {};
    const PatternedBump& normal = *bump.pattern;
    // The amount stands behind the pattern's values and before all words.
    BumpSettings words = normal.settings;
    words.bump_size = BumpSettings().bump_size;
    const std::string settings = written_fields(BumpSettings::vocabulary, &words);
    const std::string amount = message("bump_size ", normal.settings.bump_size);
    return message(" normal { ", bump.uv ? "uv_mapping " : "", use_text(normal.use), " ", amount,
                   settings.substr(std::min(settings.size(), settings.find(' '))),
                   std::visit([](const auto& map) { return map_text(map); }, normal.map),
                   matrix_text(bump.transform), " }");
}

std::string dump(const Texture& texture) {
    const std::string own = message("texture { ", layer_content(texture), " }");
    return texture.below ? message(dump(*texture.below), " ", own) : own;
}

std::string dump(const SkySphere& sky) {
    std::string text = "sky_sphere { ";
    for (const Pigment& pigment : sky.pigments) text += dump(pigment) + " ";
    return message(text, written_fields(SkySphere::vocabulary, &sky), " }\n");
}

std::string dump(const Rainbow& rainbow) {
    return message("rainbow { ", written_fields(Rainbow::vocabulary, &rainbow),
                   colours_text(rainbow.map), " }\n");
}

}  // namespace candelabra
