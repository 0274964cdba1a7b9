// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes, and what is done with objects.
#include "proof/features.h"
#include "proof/items.h"

#include <algorithm>
#include <array>

namespace candelabra::proof {

namespace {

unsigned traits_of_shape(std::string_view name) {
    using Names = std::vector<std::string_view>;
    const auto in = [&](const Names& names) { return std::ranges::count(names, name) > 0; };
    unsigned traits = no_trait;
    if (in({"model", "bicubic_patch", "cubic", "disc", "height_field", "parametric", "polygon",
            "triangle", "smooth_triangle", "plane"}))
        traits |= open_surface;
    if (in({"smooth_triangle", "mesh2"})) traits |= bends;
    if (in({"plane"})) traits |= endless;
    if (in({"bicubic_patch"})) traits |= lengths;  // its flatness is one, as in POV-Ray
    return traits;
}

Factor shapes() {
    Factor factor{"shape", {}};
    for (const char* group : {"Shapes", "Models"})
        for (const ItemInfo* info : items_of(group))
            factor.levels.push_back(
                {std::string(info->name), traits_of_shape(info->name),
                 [info](Draft& draft) { draft.shape = drawn(*info, draft.dice, 0.15); }});
    const auto sphere = std::ranges::find(factor.levels, std::string("sphere"), &Level::name);
    std::iter_swap(factor.levels.begin(), sphere);
    return factor;
}

Element with(Element object, Element part) {
    object.inner.push_back(std::move(part));
    return object;
}

Level modified(std::string name, std::string text, unsigned traits = no_trait) {
    return {name, traits, [text](Draft& draft) {
                draft.combine = [text](Draft&, Element object) {
                    return with(std::move(object), words(text));
                };
            }};
}

Level combined(std::string head, std::string other, std::string text = {},
               unsigned traits = no_trait) {
    return {head + (text.empty() ? "" : " " + text.substr(0, text.find(' '))), traits,
            [=](Draft& draft) {
                draft.combine = [=](Draft&, Element object) {
                    return block(head, "", {needed(std::move(object)), words(other), words(text)});
                };
            }};
}

Element in_light_group(Draft& draft, Element object) {
    const Element source = of_light(
        draft.new_light(), block("light_source", "<-1.5, 2.2, -1.5>, rgb @0.6@*<1, 0.9, 0.7>"));
    return block("light_group", "", {source, needed(std::move(object)), words("global_lights on")});
}

Element repeated(Draft&, Element object) {
    const std::string copy = "union { ";
    Element declared = object;
    declared.inner.push_back(words("scale 0.5 translate -0.6*x"));
    object.inner.push_back(words("scale 0.5 translate 0.5*x"));
    return block("union", "", {std::move(declared), needed(std::move(object))});
}

Factor combinations() {
    const std::string ball = "sphere { <0.4, 0.3, -0.4>, 0.45 }";
    Factor factor{"combination", {{"alone"}}};
    auto& levels = factor.levels;
    levels.push_back(combined("union", ball, "pigment { rgb <0.9, 0.4, 0.3> }"));
    levels.push_back(combined("merge", ball));
    levels.push_back(combined("intersection", "box { <-0.5, -0.5, -0.6>, <0.5, 0.6, 0.5> }"));
    levels.push_back(combined("difference", ball));
    levels.push_back(combined("difference", ball, "cutaway_textures"));
    levels.push_back({"cut out", no_trait, [](Draft& draft) {
                          draft.combine = [](Draft&, Element object) {
                              return block("difference", "box { <-0.6, -0.6, -0.5>, 0.6 }",
                                           {needed(std::move(object))});
                          };
                      }});
    levels.push_back(
        {"light_group", sources, [](Draft& draft) { draft.combine = in_light_group; }});
    levels.push_back({"twice", no_trait, [](Draft& draft) { draft.combine = repeated; }});
    levels.push_back({"row of spheres", no_trait, [](Draft& draft) {
                          draft.combine = [](Draft&, Element object) {
                              return block(
                                  "union",
                                  "#for (I, 0, 5) sphere { <0.3*I - 0.8, -0.7, -0.3>, 0.12 } #end",
                                  {needed(std::move(object))});
                          };
                      }});
    levels.push_back(
        modified("clipped", "clipped_by { plane { <0.3, 1, 0.2>, 0.1 } }", open_surface));
    levels.push_back(modified("clipped below", "clipped_by { plane { -y, 0.1 } }", open_surface));
    levels.push_back(modified("clipped by a ball", "clipped_by { sphere { <0.3, 0, -0.3>, 0.6 } }",
                              open_surface));
    levels.push_back(modified("bounded", "bounded_by { box { -1.2, 1.2 } }"));
    levels.push_back(modified("mirrored", "scale <-1, 1, 1>"));
    levels.push_back(modified("stretched", "scale <1.2, 0.5, 0.9>"));
    levels.push_back(modified("turned", "rotate <20, 130, -35>"));
    levels.push_back(modified("sheared", "matrix <1, 0.2, 0, 0.3, 0.9, 0, 0, 0.1, 1, 0, 0, 0>"));
    levels.push_back(modified("moving", "translate 0.4*clock*x", moves));
    return factor;
}

/// Whether the shape has texture coordinates: others take those of the place in the scene.
bool has_coordinates(std::string_view shape) {
    static constexpr auto shapes =
        std::to_array<std::string_view>({"sphere", "box", "torus", "ovus", "lathe", "sor",
                                         "bicubic_patch", "parametric", "mesh", "mesh2"});
    return std::ranges::count(shapes, shape) > 0;
}

/// Switches that change what some rays see, or by POV-Ray's rules more than one would see.
unsigned traits_of_switch(std::string_view name) {
    if (name == "no_shadow" || name == "no_image" || name == "no_reflection" ||
        name == "no_radiosity")
        return hides | gains;
    if (name == "double_illuminate") return gains;
    if (name == "inverse") return endless | open_surface;
    if (name == "no_luminaire") return hides;
    return no_trait;
}

Factor switches() {
    Factor factor{"switch", {{"none"}}};
    for (const char* word : {"no_shadow", "no_image", "no_reflection", "no_radiosity",
                             "no_luminaire", "hollow", "inverse", "double_illuminate"}) {
        const std::string name(word);
        factor.levels.push_back({name, traits_of_switch(name),
                                 [name](Draft& draft) { draft.modifiers.push_back(words(name)); }});
    }
    // As in POV-Ray, the bumps of an object with the switch do not turn with it.
    factor.levels.push_back({"uv_mapping", directions, [](Draft& draft) {
                                 if (has_coordinates(draft.shape.head))
                                     draft.modifiers.push_back(words("uv_mapping"));
                             }});
    factor.levels.push_back({"uv_mapping of places", directions | lengths,
                             [](Draft& draft) { draft.modifiers.push_back(words("uv_mapping")); }});
    return factor;
}

}  // namespace

std::vector<Factor> object_factors() { return {shapes(), combinations(), switches()}; }

}  // namespace candelabra::proof
