// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/laws.h"

#include <algorithm>

namespace candelabra::proof {

namespace {

/// Light that is found by chance has one reflection less than light that is sampled: so many that
/// one does not count.
const std::string paths = "path_traced bounces 25 reflected_luminaires 0";

bool has_block(const std::vector<Element>& elements, std::string_view head) {
    return std::ranges::any_of(elements, [&](const Element& each) { return each.head == head; });
}

/// Without highlights, in which only lamps show that are sampled.
Script without_highlights(Script script) {
    for (Element& each : script.elements)
        each = replaced(std::move(each), R"(\b(phong|specular)( albedo)? [0-9.]+)", "");
    return script;
}

/// Clear, with a mirror on it: a photon that meets it goes on in one of several ways.
void make_glassy(Draft& draft) {
    draft.pigment = block("pigment", "rgb <0.9, 0.8, 0.7> transmit 0.8");
    if (draft.finish.values.find("reflection") == std::string::npos)
        draft.finish.values += " reflection 0.3";
    if (!has_block(draft.modifiers, "interior"))
        draft.modifiers.push_back(block("interior", "ior 1.5"));
}

/// The element without inner sides: light that leaves a solid by its inner texture is not what a ray
/// sees that enters it by its outer one.
Element one_sided(Element element) {
    std::erase_if(element.inner,
                  [](const Element& each) { return each.head == "interior_texture"; });
    for (Element& each : element.inner) each = one_sided(std::move(each));
    return element;
}

/// The element without smoothed normals of height fields: what these bend comes back another way.
Element with_plain_heights(Element element) {
    if (element.head == "height_field") element = replaced(std::move(element), R"(\bsmooth\b)", "");
    for (Element& each : element.inner) each = with_plain_heights(std::move(each));
    return element;
}

}  // namespace

Script in_photons(Draft& draft) {
    if (draft.dice.chance(0.6)) make_glassy(draft);
    if (!has_block(draft.settings, "photons")) {
        draft.settings.push_back(block("photons", "count 2000"));
        draft.modifiers.push_back(block("photons", "target on reflection on refraction on"));
    }
    return staged(draft);
}

/// With white walls that meet behind the object: most light there has been reflected nearby.
Script in_corner(Draft& draft) {
    Script script = staged(draft);
    const std::string white = " pigment { rgb 0.9 } finish { diffuse 1 }";
    script.elements.push_back(block("box", "<-1.7, 0, 0.9>, <1.9, 1.9, 1.1>" + white));
    script.elements.push_back(block("box", "<-1.9, 0, -1.2>, <-1.7, 1.9, 1.1>" + white));
    return script;
}

Claims found_by_chance(const Script& script, Dice&) {
    Script traced = with_setting(without_highlights(script), "integrator", paths);
    for (Element& each : traced.elements) each = with_closed_sets(std::move(each));
    return {same_by_chance("sampled = found by chance", picture(traced),
                           picture(traced, {.found = Found::by_chance}))};
}

Claims photons_or_chance(const Script& script, Dice&) {
    Script traced = with_setting(without_highlights(script), "integrator", paths);
    const bool bends = mentions(traced, " ior ");
    for (Element& each : traced.elements) {
        each = with_closed_sets(with_plain_heights(one_sided(std::move(each))));
        // The light of a sky passes straight through targets, but not what paths find by chance.
        if (bends && each.head.starts_with("sky"))
            each = replaced(std::move(each), R"(\$luminaire\$)", "");
    }
    return {same_by_chance("photons = found by chance", picture(traced),
                           picture(without_setting(traced, "photons"), {.found = Found::by_chance}),
                           2e-2)};
}

Claims with_reflected_luminaires(const Script& drawn, Dice& dice) {
    const std::string bounces =
        "path_traced bounces " + dice.pick<std::string>({"1", "2", "4", "20"});
    // In a small scene all reflected luminaires are near, and bring light that paths do not.
    const Script script = dice.chance(0.5) ? transformed(drawn, "scale 0.1") : drawn;
    Claim claim = same_mean(
        "reflected luminaires or not",
        picture(with_setting(script, "integrator", bounces + " reflected_luminaires 300")),
        picture(with_setting(script, "integrator", bounces + " reflected_luminaires 0")));
    claim.effort = 2;
    return {claim};
}

}  // namespace candelabra::proof
