// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/layout.h"
#include "proof/laws.h"

#include <algorithm>

namespace candelabra::proof {

namespace {

/// Numbers that are written and read again, or multiplied in another order.
constexpr double rounding = 1e-9;

/// The script with its n-th object written by other elements.
Script rewritten(Script script, std::size_t n, std::vector<Element> by) {
    const auto at = script.elements.begin() + static_cast<std::ptrdiff_t>(n);
    const auto behind = script.elements.erase(at);
    script.elements.insert(behind, by.begin(), by.end());
    return script;
}

std::vector<Element> around(std::string before, Element object, std::string behind) {
    return {needed(words(std::move(before))), std::move(object), needed(words(std::move(behind)))};
}

/// Ways of writing an object.
struct Rewriting {
    const char* name;
    std::vector<Element> (*write)(const Element&);
};
constexpr Rewriting ways[] = {
    {"declared",
     [](const Element& object) { return around("#declare Thing =", object, "object { Thing }"); }},
    {"a macro",
     [](const Element& object) { return around("#macro Make()", object, "#end Make()"); }},
    {"a loop", [](const Element& object) { return around("#for (I, 1, 1)", object, "#end"); }},
    {"a condition",
     [](const Element& object) {
         return around("#switch (2) #case (1) sphere { 0, 9 } #break #case (2)", object,
                       "#break #end");
     }},
    {"a union of one",
     [](const Element& object) { return std::vector{block("union", "", {object})}; }},
    {"an object of it",
     [](const Element& object) { return std::vector{block("object", "", {object})}; }},
};

std::vector<std::size_t> objects_of(const Script& script) {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < script.elements.size(); ++i)
        if (is_object(script.elements[i])) result.push_back(i);
    return result;
}

/// Whether a dump has all of the scene: the meshes of cameras and motion are not in it.
bool is_whole(const std::string& dump) {
    return dump.find("mesh_camera") == dump.npos && dump.find(" shutter ") == dump.npos;
}

Term text_of_scene(std::string text, const Script& script) {
    return {std::move(text), 1, script.options};
}

}  // namespace

Claims other_writing(const Script& script, Dice& dice) {
    Claims claims;
    const auto picture_of = [&](const char* name, const Script& other) {
        claims.push_back(same_bytes(name, picture(script), picture(other), rounding));
    };
    const std::vector<std::size_t> objects = objects_of(script);
    if (!objects.empty()) {
        const std::size_t chosen = dice.pick(objects);
        const Element& object = script.elements[chosen];
        const Rewriting& way = ways[dice.below(std::size(ways))];
        const bool light = object.head == "light_source" || object.head == "light_group";
        if (!light || &way < ways + 4)
            picture_of(way.name, rewritten(script, chosen, way.write(object)));
    }
    claims.push_back(same_bytes("formatted", picture(script),
                                {text_of_scene(laid_out(written(script)), script)}));
    const auto dump = dumped({}, written(script), script.options);
    if (dump && is_whole(*dump))
        claims.push_back(
            same_bytes("dumped", picture(script), {text_of_scene(*dump, script)}, rounding));
    return claims;
}

}  // namespace candelabra::proof
