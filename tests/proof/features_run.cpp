// SPDX-License-Identifier: GPL-3.0-or-later
// How the picture is made: integrator, strategy, index, camera, shutter, film, and options.
#include "proof/features.h"
#include "proof/items.h"
#include "scene/settings.h"

#include <algorithm>
#include <array>

namespace candelabra::proof {

namespace {

void set(Draft& draft, std::string head, std::string text) {
    draft.settings.push_back(block(std::move(head), std::move(text)));
}

Factor integrators() {
    Factor factor{"integrator", {}};
    for (const ItemInfo* info : items_of("Integrators"))
        factor.levels.push_back({std::string(info->name), no_trait, [info](Draft& draft) {
                                     set(draft, "integrator", std::string(info->name));
                                 }});
    for (const char* text :
         {"bounces 2 reflected_luminaires 0", "bounces 3 reflected_luminaires 300", "bounces 0"})
        factor.levels.push_back({text, no_trait, [text](Draft& draft) {
                                     set(draft, "integrator", std::string("path_traced ") + text);
                                 }});
    return factor;
}

/// The kinds of a variant by their names, and with some of their words.
Factor choices_of(std::string_view name, std::string head, std::string_view group) {
    Factor factor{name, {{"usual"}}};
    for (const ItemInfo* info : items_of(group)) {
        factor.levels.push_back({std::string(info->name), aside,
                                 [=](Draft& draft) { set(draft, head, std::string(info->name)); }});
        if (info->fields.empty()) continue;
        factor.levels.push_back({std::string(info->name) + " drawn", aside, [=](Draft& draft) {
                                     std::string text(info->name);
                                     for (const Element& each : drawn_words(*info, draft.dice, 0.4))
                                         text += " " + each.values;
                                     set(draft, head, text);
                                 }});
    }
    return factor;
}

Factor cameras() {
    Factor factor{"camera", {}};
    for (const ItemInfo* info : items_of("Cameras")) {
        const std::string name(info->name);
        if (name == "mesh_camera" || name == "user_defined") continue;
        // As in POV-Ray, a mirrored camera of this kind does not see the mirrored scene.
        const unsigned traits = name == "spherical" ? directions : no_trait;
        factor.levels.push_back({name, traits, [name](Draft& draft) {
                                     draft.lens = name == "cylinder" ? "cylinder 1" : name;
                                 }});
    }
    const auto part = [&](std::string name, std::string text, unsigned traits = no_trait) {
        factor.levels.push_back({std::move(name), traits,
                                 [text](Draft& draft) { draft.camera.push_back(words(text)); }});
    };
    // As in POV-Ray, a scaled camera keeps its aperture.
    part("blur", "aperture 0.3 blur_samples 16 focal_point <0, 0.7, 0>", lengths);
    part("bladed", "aperture 0.3 blur_samples 16 bokeh { blades 5 angle 20 }", lengths);
    part("starred",
         "aperture 0.3 blur_samples 16 bokeh { pigment { radial frequency 5 turbulence 0.2 } }",
         lengths);
    part("tilted", "sky <0.3, 1, 0> right 1.2*x");
    // As in POV-Ray, such bumps turn directions of space.
    part("bent", "normal { bumps 0.2 scale 0.3 }", directions);
    factor.levels.push_back(
        {"mesh_camera", hides, [](Draft& draft) {
             draft.lens =
                 "mesh_camera { 1, 0 mesh { triangle { <-2, 0, -4>, <2, 0, -4>, <0, 3, -4> } } }";
         }});
    // What functions give is not moved with the camera.
    factor.levels.push_back(
        {"user_defined", hides | directions | lengths, [](Draft& draft) {
             draft.lens =
                 "user_defined location { function { x/9 } function { 1 + y/9 } function { -4 } } "
                 "direction { function { x } function { y - 0.1*x*x } function { 1 } }";
         }});
    return factor;
}

Factor shutters() {
    Factor factor{"shutter", {{"closed"}}};
    for (const char* text : {"shutter 1, 2", "shutter 0.5, 3"})
        factor.levels.push_back(
            {text, moves, [text](Draft& draft) { draft.camera.push_back(words(text)); }});
    return factor;
}

Factor films() {
    Factor factor{"film", {{"none"}}};
    const auto add = [&](std::string name, std::function<std::vector<Element>(Dice&)> parts,
                         unsigned traits) {
        factor.levels.push_back({std::move(name), traits, [parts](Draft& draft) {
                                     draft.camera.push_back(block("film", "", parts(draft.dice)));
                                 }});
    };
    add(
        "developed",
        [](Dice&) {
            return std::vector{
                words("exposure 1 white_balance 5000 response filmic"),
                block("glare", "veil 0.2 halo 0.03 star 0.1 blades 6 length 2 field 40")};
        },
        aside);
    add(
        "wide filter",
        [](Dice&) { return std::vector{words("pixel_filter mitchell smooth_edges")}; },
        aside | nonlinear);
    add(
        "drawn", [](Dice& dice) { return drawn_words(item_of("Films", "film"), dice, 0.4); },
        aside | nonlinear);
    return factor;
}

Factor options() {
    Factor factor{"option", {{"none"}}};
    const auto& info = RenderSettings::vocabulary;
    const std::array own = {"width", "height",  "samples", "noise",
                            "seed",  "threads", "quality", "ambient_luminaires"};
    for (std::size_t i = 0; i < info.fields.size(); ++i) {
        const FieldInfo& field = info.fields[i];
        if (std::ranges::count(own, field.name) > 0) continue;
        const bool off = field.type == FieldType::boolean;
        const double value = off ? 0 : std::clamp(2.0, field.range.low, field.range.high);
        factor.levels.push_back({std::string(field.name), aside, [=](Draft& draft) {
                                     draft.options.push_back({i, value});
                                 }});
    }
    factor.levels.push_back({"luminaires above", aside | nonlinear, [](Draft& draft) {
                                 draft.settings.push_back(words("luminaires above 0.5"));
                             }});
    factor.levels.push_back({"photometry", aside,
                             [](Draft& draft) { set(draft, "photometry", "unit 0.5 white 120"); }});
    factor.levels.push_back({"deep", aside, [](Draft& draft) {
                                 draft.settings.push_back(
                                     words("max_trace_level 12 adc_bailout 0.001"));
                             }});
    factor.levels.push_back(
        {"drawn settings", aside | nonlinear | gains | lengths, [](Draft& draft) {
             for (Element& each :
                  drawn_words(item_of("Settings", "global_settings"), draft.dice, 0.3))
                 if (!each.values.starts_with("assumed_gamma"))
                     draft.settings.push_back(std::move(each));
         }});
    return factor;
}

/// Meters measure the scene, and change no picture.
Factor meters() {
    Factor factor{"meter", {{"none"}}};
    const auto add = [&](std::string name, std::string place) {
        factor.levels.push_back(
            {std::move(name), no_trait, [place](Draft& draft) {
                 const auto quantity = draft.dice.pick<std::string>(
                     {"illuminance", "cylindrical", "semi_cylindrical", "hemispherical",
                      "spherical", "luminance", "luminance eye <0, 1, -3>", "ugr",
                      "threshold_increment road \"eye\"", "daylight_factor"});
                 draft.around.push_back(block("meter",
                                              "\"eye\" luminance points { 1, <0, 1, -2> } "
                                              "direction <0, -0.1, 1> cone 5"));
                 draft.around.push_back(block("meter", "\"here\" " + quantity + " " + place +
                                                           " direction <0.3, -0.1, 1> up y "
                                                           "maintenance 0.8"));
             }});
    };
    const std::string floor = "corner <-1, 0.5, -1> along 2*x across 2*z ";
    add("grid", floor + "counts <2, 3>");
    add("grid of a room", floor + "en_12464");
    add("grid of a road", floor + "en_13201 lanes 2");
    add("points", "points { 2, <0.5, 1, 0>, <-1, 0.2, 1> }");
    return factor;
}

}  // namespace

std::vector<Factor> run_factors() {
    return {integrators(),
            choices_of("strategy", "light_sampler", "Light samplers"),
            choices_of("index", "index", "Indexes"),
            cameras(),
            shutters(),
            films(),
            meters(),
            options()};
}

}  // namespace candelabra::proof
