// SPDX-License-Identifier: GPL-3.0-or-later
// Textures and what is inside: pigments, normals, finishes, interiors, and how they are put
// together.
#include "pattern/pattern.h"
#include "proof/features.h"
#include "proof/items.h"

#include <algorithm>

namespace candelabra::proof {

namespace {

bool may_stand_in(const ItemInfo& info, std::string_view block) {
    if (info.name == "density_file") return false;  // it needs a file
    const std::string_view only = home(Kinds<Pattern>::make(Kinds<Pattern>::find(info.name)));
    return only.empty() || only == block;
}

/// As in POV-Ray, the direction of a slope does not turn with its object, nor does its point move.
unsigned traits_of_pattern(std::string_view name) {
    return name == "slope" ? directions | lengths : no_trait;
}

/// The pattern with its colours as a pigment has them.
Element patterned_pigment(const ItemInfo& info, Draft& draft) {
    Dice& dice = draft.dice;
    const int colours = choices(Kinds<Pattern>::make(Kinds<Pattern>::find(info.name)));
    std::string values = std::string(info.name) + " " + drawn_values(info, dice);
    for (int i = 0; i < colours; ++i) values += (i > 0 ? ", " : " ") + drawn_colour(dice, true);
    if (info.name == "average")
        values +=
            " pigment_map { [1 rgb <0.8, 0.3, 0.2>] [2 bozo color_map { [0 rgb 0.2] [1 rgb 0.9] }] "
            "}";
    Element pigment = block("pigment", values);
    if (info.name == "image_map") return pigment;
    for (Element& each : drawn_words(info, dice, 0.3)) pigment.inner.push_back(std::move(each));
    if (colours == 0 && info.name != "average") pigment.inner.push_back(drawn_map(dice, true));
    pigment.inner.push_back(words("scale 0.4"));
    return pigment;
}

Factor pigments() {
    Factor factor{"pigment", {{"plain"}}};
    auto& levels = factor.levels;
    const auto colour = [&](std::string name, std::string text, unsigned traits) {
        levels.push_back({std::move(name), traits,
                          [text](Draft& draft) { draft.pigment = block("pigment", text); }});
    };
    colour("clear", "rgb 1 transmit 1", passes);
    colour("half clear", "rgb <0.9, 0.8, 0.7> transmit 0.5", passes);
    colour("filter", "rgb <0.6, 0.9, 0.7> filter 0.8", passes);
    colour("both", "rgb <0.6, 0.9, 0.7> filter 0.4 transmit 0.4", passes);
    for (const ItemInfo* info : items_of("Patterns"))
        if (may_stand_in(*info, "pigment"))
            levels.push_back(
                {std::string(info->name), passes | traits_of_pattern(info->name),
                 [info](Draft& draft) { draft.pigment = patterned_pigment(*info, draft); }});
    return factor;
}

/// Modifiers of the pigment's pattern, waves and warps.
Factor details() {
    Factor factor{"detail", {{"none"}}};
    const auto add = [&](std::string name, std::function<Element(Dice&)> part) {
        factor.levels.push_back({std::move(name), no_trait, [part](Draft& draft) {
                                     if (!draft.pigment.inner.empty())
                                         draft.pigment.inner.push_back(part(draft.dice));
                                 }});
    };
    add("modifiers", [](Dice& dice) {
        std::string text;
        for (const Element& each : drawn_words(item_of("Pattern modifiers", "pattern"), dice, 0.5))
            text += each.values + " ";
        return words(text + "phase 0.1");
    });
    for (const ItemInfo* info : items_of("Waves"))
        add(std::string(info->name), [info](Dice& dice) {
            return words(std::string(info->name) + " " + drawn_values(*info, dice));
        });
    for (const ItemInfo* info : items_of("Warps"))
        add("warp " + std::string(info->name), [info](Dice& dice) {
            std::string text = std::string(info->name) + " " + drawn_values(*info, dice);
            for (const Element& each : drawn_words(*info, dice, 0.3)) text += " " + each.values;
            return block("warp", text);
        });
    return factor;
}

Element patterned_normal(const ItemInfo& info, Draft& draft) {
    Dice& dice = draft.dice;
    std::string values = std::string(info.name) + " " + drawn_values(info, dice);
    if (info.name == "average") values += " normal_map { [1 bumps 0.3] [2 dents 0.3] }";
    if (info.name != "bump_map" && info.name != "average")
        values += ", " + text_of(std::round(dice.between(0.1, 0.8) * 10) / 10);
    Element normal = block("normal", values);
    for (Element& each : drawn_words(info, dice, 0.2)) normal.inner.push_back(std::move(each));
    for (Element& each : drawn_words(item_of("Surfaces", "normal"), dice, 0.15))
        if (each.values.find("bump_size") == std::string::npos)
            normal.inner.push_back(std::move(each));
    normal.inner.push_back(words("scale 0.3"));
    return normal;
}

Factor normals() {
    Factor factor{"normal", {{"none"}}};
    for (const ItemInfo* info : items_of("Patterns"))
        if (may_stand_in(*info, "normal"))
            factor.levels.push_back(
                {std::string(info->name), bends | traits_of_pattern(info->name),
                 [info](Draft& draft) { draft.normal = patterned_normal(*info, draft); }});
    const auto text = [&](std::string name, std::string values) {
        factor.levels.push_back({std::move(name), bends, [values](Draft& draft) {
                                     draft.normal = block("normal", values);
                                 }});
    };
    text("slope_map",
         "gradient x, 0.5 slope_map { [0 <0, 1>] [0.5 <1, 0>] [1 <0, -1>] } scale 0.3");
    text("normal_map", "gradient y normal_map { [0 bumps 0.4 scale 0.2] [1 dents 0.5] }");
    return factor;
}

unsigned traits_of_finish(std::string_view word) {
    if (word == "conserve_energy" || word == "metallic" || word == "diffuse") return no_trait;
    if (word == "refraction" || word == "ior") return gains | refracts;
    return gains;
}

void finish_words(Factor& factor) {
    for (const FieldInfo& field : item_of("Surfaces", "finish").fields) {
        const std::string name(field.name);
        if (!field.is_word() || name == "emission" || name == "no_luminaire" || name == "ambient" ||
            name == "caustics")
            continue;
        factor.levels.push_back(
            {name, traits_of_finish(name), [name](Draft& draft) {
                 for (Element& each : drawn_words(item_of("Surfaces", "finish"), draft.dice, 1))
                     if (each.values == name || each.values.starts_with(name + " "))
                         draft.finish = name == "diffuse"
                                            ? block("finish", each.values)
                                            : block("finish", "diffuse 0.6", {std::move(each)});
             }});
    }
}

void finish_blocks(Factor& factor) {
    const auto text = [&](std::string name, std::string values, unsigned traits = no_trait) {
        factor.levels.push_back({std::move(name), traits, [values](Draft& draft) {
                                     draft.finish = block("finish", values);
                                 }});
    };
    text("both sides", "diffuse 0.4, 0.4");
    text("black", "diffuse 0");
    text("white", "diffuse 1");
    text("glossy", "diffuse 0.5 phong 0.5 specular 0.4 roughness 0.05", gains);
    text("mirror", "diffuse 0 reflection 0.9");
    text("glass", "diffuse 0 reflection { 0, 1 fresnel } conserve_energy");
    text("metal", "diffuse 0.3 reflection { 0.6 metallic }");
    text("ambient", "diffuse 0.6 ambient @0.2@", gains | nonlinear);
    text("subsurface", "diffuse 0.6 subsurface { translucency <0.5, 0.4, 0.3> }", gains | lengths);
    const auto item = [&](std::string name, const ItemInfo& info, unsigned traits) {
        factor.levels.push_back({std::move(name), traits, [&info](Draft& draft) {
                                     draft.finish = block("finish", "diffuse 0.4",
                                                          {drawn(info, draft.dice, 0.4)});
                                 }});
    };
    item("reflection", item_of("Surfaces", "reflection"), gains | nonlinear);
    item("irid", item_of("Surfaces", "irid"), gains);
    item("microfacet", item_of("Surfaces", "microfacet"), no_trait);
    text("rough metal", "microfacet { roughness 0.4 metallic 1 }");
    text("lacquer", "microfacet { roughness 0.6 coat 1 coat_roughness 0.1 }");
}

Factor finishes() {
    Factor factor{"finish", {{"matte"}}};
    finish_words(factor);
    finish_blocks(factor);
    return factor;
}

/// A texture with a map of textures, between whose brackets the parts of one stand.
Element mapped(std::string pattern, std::string before, const Element& texture,
               std::string behind) {
    Element map = block("texture_map", "", {needed(words(std::move(before)))});
    map.inner.insert(map.inner.end(), texture.inner.begin(), texture.inner.end());
    map.inner.push_back(needed(words(std::move(behind))));
    return block("texture", std::move(pattern), {std::move(map)});
}

Factor structures() {
    using Textures = std::vector<Element>;
    Factor factor{"texture", {{"one"}}};
    const auto add = [&](std::string name, std::function<Textures(Draft&, Element)> make) {
        factor.levels.push_back(
            {std::move(name), no_trait, [make](Draft& draft) { draft.structure = make; }});
    };
    const auto inside = [](std::string head, const Element& texture) {
        return block(std::move(head), "", texture.inner);
    };
    add("layers", [](Draft&, Element texture) {
        return Textures{texture,
                        block("texture",
                              "pigment { gradient y color_map { [0 rgb <0.2, 0.3, 0.7>] "
                              "[0.4 rgb 1 transmit 1] } scale 0.5 } finish { diffuse 0.6 }")};
    });
    add("layer below", [](Draft&, Element texture) {
        return Textures{block("texture",
                              "pigment { checker rgb <0.2, 0.6, 0.4>, rgb 0.9 scale 0.3 } finish { "
                              "diffuse 0.7 }"),
                        texture};
    });
    add("texture_map", [=](Draft&, Element texture) {
        return Textures{mapped("bozo scale 0.5", "[0.4", texture,
                               "] [0.6 pigment { rgb <0.4, 0.5, 0.9> } finish { diffuse 0.6 }]")};
    });
    add("checker of textures", [=](Draft&, Element texture) {
        return Textures{block(
            "texture", "checker",
            {needed(inside("texture", texture)),
             needed(block("texture",
                          "pigment { rgb <0.3, 0.8, 0.5> } finish { diffuse 0.6 reflection 0.2 }")),
             words("scale 0.4")})};
    });
    add("tiles", [=](Draft&, Element texture) {
        return Textures{block(
            "texture", "",
            {block("tiles", "",
                   {needed(inside("texture", texture)), words("tile2"),
                    needed(block("texture", "pigment { rgb 0.6 } finish { diffuse 0.6 }"))})})};
    });
    add("average of textures", [=](Draft&, Element texture) {
        return Textures{mapped("average", "[1", texture,
                               "] [2 pigment { rgb <0.9, 0.8, 0.2> } finish { diffuse 0.6 }]")};
    });
    add("material",
        [](Draft&, Element texture) { return Textures{block("material", "", {texture})}; });
    add("moved", [](Draft&, Element texture) {
        texture.inner.push_back(words("rotate 40*z scale 0.7 translate 0.2"));
        return Textures{texture};
    });
    return factor;
}

Factor inner_textures() {
    Factor factor{"inner texture", {{"none"}}};
    const auto add = [&](std::string name, std::string text, unsigned traits = no_trait) {
        factor.levels.push_back({std::move(name), traits, [=](Draft& draft) {
                                     Element inner = block("interior_texture", text);
                                     if (traits & glows) inner.light = draft.new_light();
                                     draft.modifiers.push_back(inner);
                                 }});
    };
    add("dark", "pigment { rgb 0.1 } finish { diffuse 0.5 }");
    add("clear", "pigment { rgb 1 transmit 0.8 } finish { diffuse 0.3 }", passes);
    add("mirror", "pigment { rgb 1 } finish { diffuse 0.1 reflection 0.7 }");
    add("glowing",
        "pigment { rgb <1, 0.8, 0.6> } finish { diffuse 0.3 emission @2@ $no_luminaire$ }", glows);
    return factor;
}

/// Media are seen in clear solids only.
void make_clear(Draft& draft) {
    draft.pigment = block("pigment", "rgb 1 transmit 1");
    draft.finish = block("finish", "diffuse 0");
    draft.modifiers.push_back(words("hollow"));
}

Factor interiors() {
    Factor factor{"interior", {{"none"}}};
    auto& levels = factor.levels;
    const auto add = [&](std::string name, std::string text, unsigned traits) {
        levels.push_back({std::move(name), traits, [=](Draft& draft) {
                              Element interior = block("interior", text);
                              if (traits & glows) interior.light = draft.new_light();
                              if (traits & dims) make_clear(draft);
                              draft.modifiers.push_back(interior);
                          }});
    };
    add("glass", "ior 1.5", refracts | passes);
    add("bubble", "ior 0.8", refracts | passes);
    add("prism", "ior 1.5 dispersion 1.1 dispersion_samples 5", refracts | passes);
    levels.push_back({"drawn", refracts | passes | lengths, [](Draft& draft) {
                          draft.modifiers.push_back(
                              block("interior", "",
                                    drawn_words(item_of("Surfaces", "interior"), draft.dice, 0.4)));
                      }});
    add("fading", "ior 1.2 fade_distance 0.5 fade_power 1 fade_color rgb <0.3, 0.7, 0.5>",
        refracts | passes | lengths | dims);
    add("caustics", "ior 1.3 caustics 0.6", refracts | passes | gains);
    add("absorbing", "media { absorption <0.5, 1, 1.5> }", lengths | dims | passes);
    add("glowing", "media { emission @0.5@*<1, 0.8, 0.4> absorption 0.5 } $luminaire$",
        lengths | dims | glows | passes);
    add("glowing clouds",
        "media { emission @1@*<1, 0.8, 0.4> density { bozo color_map { [0.3 rgb 0] [0.7 rgb 1] } "
        "scale 0.3 } } $luminaire$",
        lengths | dims | glows | passes);
    for (int type = 1; type <= 5; ++type)
        add("scattering " + std::to_string(type),
            "media { scattering { " + std::to_string(type) + ", rgb <0.8, 0.6, 0.4>" +
                (type == 5 ? " eccentricity 0.4" : "") + " } }",
            lengths | dims | scatters | passes);
    add("multiple scattering", "media { scattering { 1, rgb 0.8 multiple } }",
        lengths | dims | scatters | passes);
    add("smoke",
        "media { scattering { 1, rgb 0.8 extinction 0.5 } absorption 0.3 density { spherical "
        "color_map { [0 rgb 0] [1 rgb 2] } } }",
        lengths | dims | scatters | passes | gains);
    return factor;
}

}  // namespace

std::vector<Factor> surface_factors() {
    return {pigments(),   details(),        normals(),  finishes(),
            structures(), inner_textures(), interiors()};
}

}  // namespace candelabra::proof
