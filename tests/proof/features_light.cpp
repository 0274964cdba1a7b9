// SPDX-License-Identifier: GPL-3.0-or-later
// Lamps, light sources, the sky, fog and media of the open, photons and radiosity.
#include "proof/features.h"
#include "proof/items.h"

#include <algorithm>

namespace candelabra::proof {

namespace {

const std::string glow =
    "pigment { rgb <1, 0.8, 0.6> } finish { diffuse 0 emission @3@ $no_luminaire$ } ";

void add_lamp(Draft& draft, Element lamp) {
    draft.around.push_back(of_light(draft.new_light(), std::move(lamp)));
}

Level lamp(std::string name, std::string head, std::string values, unsigned traits = glows) {
    return {name, traits | glows, [=](Draft& draft) { add_lamp(draft, block(head, values)); }};
}

/// A lamp of each shape, beside the tested object.
void lamps_by_shape(std::vector<Level>& levels) {
    for (const ItemInfo* info : items_of("Shapes"))
        if (info->name != "plane")
            levels.push_back(
                {"lamp " + std::string(info->name),
                 glows | (info->name == "mesh2" || info->name == "smooth_triangle" ? bends : 0u),
                 [info](Draft& draft) {
                     Element shape = drawn(*info, draft.dice, 0.1);
                     shape.inner.push_back(words(glow));
                     shape.inner.push_back(words("scale 0.8 translate <-1.3, 2.3, -0.9>"));
                     add_lamp(draft, std::move(shape));
                 }});
}

Level glowing_object(std::string name, std::string finish, unsigned traits = no_trait) {
    return {name, traits | glows, [=](Draft& draft) {
                Element part = words(finish);
                part.light = draft.new_light();
                draft.finish.inner.push_back(part);
            }};
}

Factor luminaires() {
    Factor factor{"luminaire", {{"none"}}};
    auto& levels = factor.levels;
    lamps_by_shape(levels);
    const std::string place = "scale 0.8 translate <-1.3, 2.3, -0.9> ";
    levels.push_back(glowing_object("the object", "emission @1.5@ $no_luminaire$"));
    levels.push_back(lamp("clipped ball", "sphere",
                          "0, 0.7 " + glow + "clipped_by { plane { y, 0 } } " + place));
    levels.push_back(lamp("bowl", "difference",
                          "sphere { 0, 0.8 } sphere { 0, 0.7 } plane { -y, 0 } pigment { rgb 1 } "
                          "finish { diffuse 0.6 emission @2@ $no_luminaire$ } " +
                              place));
    levels.push_back(lamp("glowing room", "difference",
                          "box { -6, 6 } box { -5.5, 5.5 } pigment { rgb 1 } finish { diffuse 0.5 "
                          "emission @0.4@ $no_luminaire$ } translate 5*y",
                          endless));
    levels.push_back(lamp("dome", "sphere",
                          "0, 20 hollow pigment { rgb <0.6, 0.8, 1> } finish { diffuse 0 emission "
                          "@0.7@ $no_luminaire$ }",
                          endless));
    levels.push_back(
        lamp("union of lamps", "union",
             "sphere { -0.4*x, 0.4 } box { <0.1, -0.3, -0.3>, <0.6, 0.3, 0.3> } " + glow + place));
    levels.push_back(lamp("merged lamps", "merge",
                          "sphere { -0.2*x, 0.5 } sphere { 0.3*x, 0.5 } " + glow + place));
    levels.push_back(lamp("one side", "disc",
                          "0, <0.4, -1, 0.3>, 0.8 texture { " + glow +
                              "} interior_texture { pigment { rgb 0.2 } finish { diffuse 0.5 } } " +
                              place));
    levels.push_back(lamp(
        "inner side", "sphere",
        "0, 1 hollow texture { pigment { rgb 0.2 } finish { diffuse 0.5 } } interior_texture { " +
            glow + "} clipped_by { plane { y, 0 } } " + place));
    levels.push_back(lamp("patterned", "sphere",
                          "0, 0.8 pigment { checker rgb 1, rgb <0.2, 0.4, 1> scale 0.3 } finish { "
                          "diffuse 0 emission @4@ $no_luminaire$ } " +
                              place));
    levels.push_back(lamp("in lumens", "torus",
                          "0.6, 0.2 pigment { rgb 1 } finish { diffuse 0 luminaire { flux @9@ "
                          "temperature 3000 lamp_set 1 aim -y c0 x mirrored } $no_luminaire$ } " +
                              place,
                          lengths));
    levels.push_back(lamp("union in lumens", "union",
                          "sphere { -0.4*x, 0.4 } box { <0.1, -0.3, -0.3>, <0.6, 0.3, 0.3> "
                          "scale <1, 2, 1> } " +
                              glow + "luminaire { flux @12@ } " + place,
                          lengths));
    levels.push_back(lamp("half clear", "box",
                          "-0.6, 0.6 pigment { rgb 1 transmit 0.5 } finish { diffuse 0 emission "
                          "@4@ $no_luminaire$ } " +
                              place));
    levels.push_back(lamp("layered", "sphere",
                          "0, 0.7 texture { " + glow +
                              "} texture { pigment { gradient y color_map { [0.5 rgb 0.1] [0.5 rgb "
                              "1 transmit 1] } } finish { diffuse 0.4 } } " +
                              place));
    levels.push_back(
        lamp("in glass", "union",
             "sphere { 0, 0.5 " + glow +
                 "} sphere { 0, 0.8 hollow pigment { rgb 1 transmit 1 } finish { diffuse 0 "
                 "reflection { 0, 1 fresnel } conserve_energy } interior { ior 1.5 } } " +
                 place,
             refracts | in_lens));
    levels.push_back(lamp(
        "behind a pane", "union",
        "sphere { 0.3*y, 0.5 " + glow +
            "} box { <-0.9, -0.5, -0.9>, <0.9, -0.4, 0.9> pigment { rgb 1 transmit 1 } finish { "
            "diffuse 0 reflection { 0, 1 fresnel } conserve_energy } interior { ior 1.5 } } " +
            place,
        refracts));
    levels.push_back(lamp("behind a filter", "union",
                          "sphere { 0.3*y, 0.5 " + glow +
                              "} box { <-0.9, -0.5, -0.9>, <0.9, -0.4, 0.9> pigment { rgb <0.4, "
                              "0.8, 1> filter 0.8 } finish { diffuse 0.2 } } " +
                              place));
    levels.push_back(lamp("twins", "union",
                          "sphere { 0, 0.5 " + glow + "} sphere { 0, 0.5 " + glow + "} " + place,
                          gains));
    levels.push_back(lamp("many", "union",
                          "#for (I, 0, 23) sphere { <1.6*sin(I), 1.2 + 0.05*I, 1.6*cos(I)>, 0.05 "
                          "pigment { rgb 1 } finish { emission @20@ $no_luminaire$ } } #end",
                          tiny_light));
    levels.push_back(
        lamp("far and near", "union",
             "sphere { <1e6, 2e6, -1e6>, 2e5 pigment { rgb 1 } finish { diffuse 0 emission @10@ "
             "$no_luminaire$ } } #for (I, 0, 15) sphere { <2*sin(I), 0.5, 2*cos(I)>, 0.03 pigment "
             "{ rgb 1 } finish { emission @60@ $no_luminaire$ } } #end",
             tiny_light | endless));
    levels.push_back(lamp("bright medium", "sphere",
                          "0, 0.9 hollow pigment { rgb 1 transmit 1 } finish { diffuse 0 } "
                          "interior { media { emission @2@*<1, 0.8, 0.6> } $luminaire$ } " +
                              place,
                          dims | lengths));
    levels.push_back(
        lamp("clipped medium", "sphere",
             "0, 0.9 hollow pigment { rgb 1 transmit 1 } finish { diffuse 0 } interior { media { "
             "emission @2@ absorption 0.3 } $luminaire$ } clipped_by { plane { -y, 0 } } " +
                 place,
             dims | lengths));
    levels.push_back(lamp("medium around all", "box",
                          "-9, 9 hollow pigment { rgb 1 transmit 1 } finish { diffuse 0 } interior "
                          "{ media { emission @0.05@ absorption 0.05 } $luminaire$ }",
                          dims | lengths | endless));
    // It is no luminaire, so it lights a surface only by paths that meet it.
    levels.push_back(lamp("medium without bounds", "sphere",
                          "0, 0.6 inverse hollow pigment { rgb 1 transmit 1 } finish { diffuse 0 } "
                          "interior { media { emission @0.1@ absorption 0.1 } $luminaire$ } " +
                              place,
                          dims | lengths | endless | veils));
    levels.push_back(
        lamp("hidden from the camera", "sphere", "0, 0.7 no_image " + glow + place, hides));
    levels.push_back(
        lamp("without shadow", "sphere", "0, 0.7 no_shadow " + glow + place, hides | gains));
    levels.push_back(
        lamp("moving lamp", "sphere", "0, 0.6 " + glow + place + "translate clock*x", moves));
    return factor;
}

Level source(std::string name, std::string text, unsigned traits = no_trait) {
    return {name, traits | sources, [=](Draft& draft) {
                add_lamp(draft,
                         block("light_source", "<-2, 3, -2.5>, rgb @0.8@*<1, 0.9, 0.8> " + text));
            }};
}

Factor light_sources() {
    Factor factor{"source", {{"none"}}};
    auto& levels = factor.levels;
    levels.push_back(source("point", ""));
    levels.push_back(source("fading", "fade_distance 2 fade_power 2", lengths));
    levels.push_back(
        source("spotlight", "spotlight point_at <0, 0.5, 0> radius 12 falloff 20 tightness 5"));
    levels.push_back(
        source("cylinder", "cylinder point_at <0, 0.5, 0> radius 0.8 falloff 1.4", lengths));
    levels.push_back(source("in candela", "intensity @9@", lengths));
    levels.push_back(source("spot in lumens",
                            "flux @20@ spotlight point_at <0, 0.5, 0> radius 20 falloff 30",
                            lengths));
    levels.push_back(source("parallel", "parallel point_at <0, 0.5, 0>"));
    levels.push_back(source("area", "area_light x, z, 3, 3 adaptive 1 jitter"));
    levels.push_back(
        source("area disc", "area_light x, z, 5, 5 circular orient area_illumination on"));
    levels.push_back(source("shadowless", "shadowless"));
    levels.push_back(source("dimmed by fog", "media_attenuation on", dims));
    levels.push_back(source("no media", "media_interaction off", gains));
    levels.push_back(source("through a window",
                            "projected_through { disc { <-1, 1.7, -1.2>, <2, -2.5, 2.5>, 0.5 } }"));
    levels.push_back(source(
        "lamp that is seen",
        "looks_like { sphere { 0, 0.2 pigment { rgb 1 } finish { emission @1@ no_luminaire } } }",
        glows | gains));
    levels.push_back({"drawn", sources | lengths | tiny_light, [](Draft& draft) {
                          Element light =
                              block("light_source", "<-2, 3, -2.5>, rgb @0.8@",
                                    drawn_words(*items_of("Lights").front(), draft.dice, 0.2));
                          const auto has = [](std::string_view word) {
                              return [word](const Element& each) {
                                  return each.values.starts_with(word);
                              };
                          };
                          // Parallel light has no intensity, and other light has it or a flux.
                          const bool parallel = std::ranges::any_of(light.inner, has("parallel")) ||
                                                std::ranges::any_of(light.inner, has("cylinder"));
                          if (parallel) std::erase_if(light.inner, has("intensity"));
                          if (parallel || std::ranges::any_of(light.inner, has("intensity")))
                              std::erase_if(light.inner, has("flux"));
                          if (std::ranges::any_of(light.inner, has("intensity")) ||
                              std::ranges::any_of(light.inner, has("flux")))
                              std::erase_if(light.inner, has("fade_"));
                          // They are the light's amount, and its colour is none then.
                          for (Element& each : light.inner)
                              for (const std::string word : {"intensity ", "flux "})
                                  if (each.values.starts_with(word))
                                      each.values =
                                          word + "@" + each.values.substr(word.size()) + "@";
                          add_lamp(draft, std::move(light));
                      }});
    return factor;
}

Factor skies() {
    Factor factor{"sky", {{"none"}}};
    const auto add = [&](std::string name, std::string head, std::string text,
                         unsigned traits = glows) {
        factor.levels.push_back({std::move(name), traits | glows,
                                 [=](Draft& draft) { add_lamp(draft, block(head, text)); }});
    };
    add("background", "background", "rgb @0.3@*<0.6, 0.8, 1>");
    add("sky", "sky_sphere",
        "pigment { gradient y color_map { [0 rgb <0.9, 0.6, 0.4>] [1 rgb <0.2, 0.4, 0.9>] } } "
        "emission @0.5@",
        directions);
    add("bright sky", "sky_sphere",
        "pigment { gradient y color_map { [0 rgb <0.9, 0.6, 0.4>] [1 rgb <0.2, 0.4, 0.9>] } } "
        "emission @0.5@ $luminaire$",
        directions);
    add("even bright sky", "sky_sphere",
        "pigment { rgb <0.6, 0.8, 1> } emission @0.5@ $luminaire$");
    // A sky by its formula, whose numbers are radiances and colours of the sun, which is a light
    // source.
    const auto measured = [&](std::string name, std::string text, bool sun = true) {
        add(std::move(name), "sky_luminance",
            text + " zenith @0.3@ direct " + (sun ? "@0.4@" : "0") +
                " ground 0.3 north z up y temperature 6000",
            sun ? directions | sources : directions);
    };
    measured("overcast sky", "cie overcast sun <40, 30>", false);
    measured("uniform sky", "uniform sun <40, 30>", false);
    measured("partly cloudy sky", "partly_cloudy sun <40, 30>");
    measured("clear sky", "clear sun <40, 30>");
    measured("turbid sky", "turbid sun <40, 30>", false);
    measured("sky by place", "type 12 place <40, 0> date <2026, 6, 21> time 15 zone 0");
    measured("sky by weather", "perez clearness 3 brightness 0.2 sun <50, 30>");
    add("sky by irradiance", "sky_luminance",
        "perez irradiance <500, 150> diffuse @0.3@ direct @0.4@ sun <50, 30> temperature 6000",
        directions | sources);
    add("two skies", "sky_sphere",
        "pigment { rgb <0.2, 0.3, 0.6> } pigment { bozo color_map { [0.5 rgb 1 transmit 1] [0.8 "
        "rgb 1] } scale 0.3 } emission @0.4@ $luminaire$",
        directions);
    return factor;
}

Factor airs() {
    Factor factor{"air", {{"clear"}}};
    auto& levels = factor.levels;
    const auto add = [&](std::string name, std::string head, std::string text, unsigned traits) {
        levels.push_back({std::move(name), traits | lengths, [=](Draft& draft) {
                              Element air = block(head, text);
                              if (traits & glows) air.light = draft.new_light();
                              draft.around.push_back(air);
                          }});
    };
    add("black fog", "fog", "rgb 0 distance 8", fogs | dims);
    add("fog", "fog", "rgb @0.4@*<0.8, 0.9, 1> distance 10", fogs | dims | glows);
    add("low fog", "fog", "fog_type 2 rgb @0.3@ distance 4 fog_offset 0.4 fog_alt 0.4",
        fogs | dims | glows | directions);
    add("uneven fog", "fog", "rgb @0.3@ distance 8 turbulence 0.5 turb_depth 0.4 octaves 3",
        fogs | dims | glows | directions);
    add("thin fog", "fog", "rgb @0.4@ filter 0.3 transmit 0.2 distance 6",
        fogs | dims | glows | nonlinear | veils);
    levels.push_back({"drawn fog", veils | fogs | dims | glows | directions | lengths | nonlinear,
                      [](Draft& draft) {
                          Element fog =
                              block("fog", "rgb @0.3@ distance 9",
                                    drawn_words(item_of("Surroundings", "fog"), draft.dice, 0.3));
                          std::erase_if(fog.inner, [](const Element& each) {
                              return each.values.starts_with("distance");
                          });
                          fog.light = draft.new_light();
                          draft.around.push_back(fog);
                      }});
    add("absorption", "media", "absorption <0.05, 0.1, 0.15>", dims);
    add("glowing air", "media", "emission @0.03@ absorption 0.05", dims | glows);
    add("haze", "media", "scattering { 1, rgb 0.06 }", dims | scatters);
    add("deep haze", "media", "scattering { 1, rgb 0.08 multiple }", dims | scatters);
    add("forward haze", "media", "scattering { 5, rgb 0.06 eccentricity 0.5 }", dims | scatters);
    add("blue air", "media", "scattering { 4, rgb <0.03, 0.06, 0.12> extinction 0.5 }",
        dims | scatters | gains);
    add("patches", "media",
        "absorption 0.3 density { bozo color_map { [0.4 rgb 0] [0.6 rgb 1] } scale 0.6 }",
        dims | directions);
    levels.push_back({"drawn media", dims | directions | lengths | nonlinear, [](Draft& draft) {
                          Element media =
                              block("media", "absorption 0.05 scattering { 1, rgb 0.03 }",
                                    drawn_words(item_of("Surroundings", "media"), draft.dice, 0.2));
                          std::erase_if(media.inner, [](const Element& each) {
                              return each.values.starts_with("emission") ||
                                     each.values.starts_with("absorption") ||
                                     each.values.starts_with("scattering");
                          });
                          draft.around.push_back(media);
                      }});
    add("rainbow", "rainbow",
        "direction <0.3, -0.4, 1> angle 30 width 12 distance 20 arc_angle 120 falloff_angle 60 "
        "color_map { [0 rgb <1, 0, 0> "
        "transmit 0.7] [1 rgb <0, 0, 1> transmit 0.7] }",
        fogs | dims | glows | directions | nonlinear);
    return factor;
}

Factor photons() {
    Factor factor{"photons", {{"none"}}};
    const auto add = [&](std::string name, std::string global, std::string object,
                         unsigned traits = photon_light) {
        factor.levels.push_back({std::move(name), traits, [=](Draft& draft) {
                                     draft.settings.push_back(block("photons", global));
                                     draft.modifiers.push_back(block("photons", object));
                                 }});
    };
    add("mirrored and broken", "count 1500", "target on reflection on refraction on");
    add("broken", "spacing 0.05", "target 1 refraction on collect off", photon_light | lengths);
    add("in media", "count 1500 media 20", "target on refraction on reflection on");
    add("no target", "count 1200", "collect on pass_through");
    factor.levels.push_back(
        {"drawn", photon_light | lengths, [](Draft& draft) {
             Element global = block("photons", "count 1200",
                                    drawn_words(item_of("Settings", "photons"), draft.dice, 0.15));
             std::erase_if(global.inner, [](const Element& each) {
                 return each.values.starts_with("count") || each.values.starts_with("spacing");
             });
             draft.settings.push_back(global);
             draft.modifiers.push_back(
                 block("photons", "",
                       drawn_words(*items_of("Photons of objects").front(), draft.dice, 0.6)));
         }});
    return factor;
}

Factor radiosities() {
    Factor factor{"radiosity", {{"none"}}};
    for (int limit = 1; limit <= 2; ++limit)
        factor.levels.push_back({"limit " + std::to_string(limit), gathers, [limit](Draft& draft) {
                                     draft.settings.push_back(block(
                                         "radiosity", "recursion_limit " + std::to_string(limit)));
                                 }});
    factor.levels.push_back(
        {"drawn", gathers | nonlinear | gains, [](Draft& draft) {
             Element block_of =
                 block("radiosity", "recursion_limit 1",
                       drawn_words(item_of("Settings", "radiosity"), draft.dice, 0.2));
             std::erase_if(block_of.inner, [](const Element& each) {
                 return each.values.starts_with("recursion_limit");
             });
             draft.settings.push_back(block_of);
         }});
    return factor;
}

}  // namespace

std::vector<Factor> light_factors() {
    return {luminaires(), light_sources(), skies(), airs(), photons(), radiosities()};
}

}  // namespace candelabra::proof
