// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/laws.h"

#include <regex>

namespace candelabra::proof {

namespace {

const std::string deep_paths = "path_traced bounces 50 reflected_luminaires ";

/// The element with white pigments, whose diffuse surfaces glow as much as they absorb, and reflect
/// no more than they receive.
Element whitened(Element element) {
    // The default colours of a pattern are not white.
    if (element.head == "pigment" && !mentions(element, "rgb")) return block("pigment", "rgb 1");
    element = replaced(std::move(element), "rgb (<[^>]*>|[0-9.]+)", "rgb 1");
    element = replaced(std::move(element), R"(image_map \{[^{}]*\})", "rgb 1");
    element = replaced(std::move(element), "(diffuse [^{}]*) emission [0-9.]+", "$1");
    static const std::regex diffuse("diffuse ([0-9.]+)(, ([0-9.]+))?( reflection ([0-9.]+))?");
    std::smatch found;
    // Of a reflection with angles nobody knows the share: then the surface only loses light.
    const bool angles = element.values.find("reflection {") != std::string::npos;
    if (!angles && element.inner.empty() && std::regex_search(element.values, found, diffuse)) {
        double share = 0;
        for (const int part : {1, 3, 5})
            if (found[part].matched) share += std::stod(found[part]);
        if (share < 1)
            element.values = found.prefix().str() + found[0].str() + " emission " +
                             text_of(1 - share) + found.suffix().str();
        else if (share > 1)
            element.values = found.prefix().str() + "diffuse 1" + found.suffix().str();
    }
    for (Element& each : element.inner)
        each = each.head == "image_map" ? words("rgb 1") : whitened(std::move(each));
    return element;
}

/// The element whose finishes reflect only what their pigments do not let through. POV-Ray's rule
/// for clear pigments adds both, unless a finish has `conserve_energy`.
Element conserving(Element element) {
    if (element.head == "finish" && mentions(element, "reflection") &&
        !mentions(element, "conserve_energy"))
        element.values += " conserve_energy";
    for (Element& each : element.inner) each = conserving(std::move(each));
    return element;
}

/// The objects of the script as things that neither make nor lose light. A smaller script is
/// whitened again: its finishes are others.
Script white(Script script) {
    for (Element& each : script.elements) {
        if (!is_object(each)) continue;
        each = whitened(with_plain_models(std::move(each)));
        if (mentions(each, "transmit") || mentions(each, "filter"))
            each = conserving(std::move(each));
    }
    return script;
}

Element white_default() {
    return needed(block("#default", "pigment { rgb 1 } finish { ambient 0 diffuse 1 }"));
}

/// Whether surfaces lose light that nothing gives back.
bool loses(const Script& script) {
    for (const char* word : {"reflection", "microfacet", "brilliance", "metallic",
                             "conserve_energy", "fade_power", "smooth"})
        if (mentions(script, word)) return true;
    // What lets light in on one side only may keep it for ever.
    return mentions(script, "inverse") && mentions(script, "interior_texture");
}

Element white_settings(Draft& draft) {
    return needed(
        block("global_settings", "assumed_gamma 1 max_trace_level 50 adc_bailout 0",
              {needed(block("integrator", deep_paths + (draft.dice.chance(0.5) ? "0" : "300")))}));
}

/// Light of 1 from everywhere.
Element surroundings(Draft& draft) {
    return needed(draft.dice.pick<Element>(
        {block("background", "rgb 1"), block("sky_sphere", "pigment { rgb 1 } luminaire"),
         block("sphere", "0, 30 hollow pigment { rgb 1 } finish { diffuse 0 emission 1 }"),
         block("box", "-9, 9 hollow pigment { rgb 1 } finish { diffuse 0.6 emission 0.4 }")}));
}

}  // namespace

Script in_furnace(Draft& draft) {
    Script script;
    script.elements = {white_default(), white_settings(draft),
                       needed(block("camera", "location <0.3, 0.9, -2.8> look_at 0 angle 40")),
                       surroundings(draft), tested_object(draft)};
    return script;
}

Claims constant_one(const Script& script, Dice&) {
    Claim claim = same_mean("at most 1", picture(white(script)), {}, 1e-2);
    claim.constant = 1;
    claim.bound = loses(script) ? Bound::at_most : Bound::equal;
    if (claim.bound == Bound::equal) claim.name = "1 everywhere";
    return {claim};
}

Script white_floor(Draft& draft) {
    Script script;
    // A finish that states a diffuse share above 1 gains light by what it says.
    Element texture = block("texture", "pigment { rgb 1 }",
                            {replaced(draft.finish, R"(diffuse 1\.[0-9]+)", "diffuse 1")});
    if (draft.normal) texture.inner.push_back(*draft.normal);
    script.elements = {needed(block("#default", "finish { ambient 0 }")), white_settings(draft),
                       block("background", "rgb 1"), block("plane", "y, 0", {texture})};
    return script;
}

Claims at_most_white(const Script& script, Dice&) {
    Claims claims;
    for (const char* elevation : {"90", "30", "10", "3"}) {
        Script seen = script;
        seen.elements.push_back(block("camera", "perspective location -10*z rotate " +
                                                    std::string(elevation) +
                                                    "*x look_at 0 angle 4"));
        Claim claim = same_mean("at most 1 from " + std::string(elevation) + " degrees",
                                picture(seen), {}, 2e-2);
        claim.constant = 1;
        claim.bound = Bound::at_most;
        claims.push_back(claim);
    }
    return claims;
}

}  // namespace candelabra::proof
