// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/glossary.h"

#include "text/ascii.h"

#include <algorithm>
#include <array>

namespace candelabra {

namespace {

constexpr auto entries = std::to_array<GlossaryEntry>({
    // directives
    {"declare",
     "#declare Name = value;",
     "gives a name to a number, vector, colour, string, array, function, object, texture or other "
     "part of a scene, until the end, everywhere",
     {"#declare Height = 1.6; box { 0, <1, Height, 1> }"}},
    {"local",
     "#local Name = value;",
     "declares a name for the rest of the macro or included file",
     {"#macro Post(Tall) #local Wide = Tall/10; box { -Wide, <Wide, Tall, Wide> } #end Post(2)"}},
    {"undef", "#undef Name", "takes a name away", {"#declare Height = 1.6; #undef Height"}},
    {"if elseif else",
     "#if (condition) ... #elseif (condition) ... #else ... #end",
     "chooses; any number but 0 is true",
     {"#declare Storeys = 3; #if (Storeys > 5) box { 0, <1, 3, 1> } #elseif (Storeys > 2) box { 0, "
      "2 } #else box { 0, 1 } #end"}},
    {"ifdef ifndef",
     "#ifdef(Name) ... #else ... #end",
     "tests whether a name is declared, or not",
     {"#ifndef (Storeys) #declare Storeys = 3; #end #ifdef (Storeys) box { 0, <1, Storeys/2, 1> } "
      "#end"}},
    {"for",
     "#for (Name, first, last[, step]) ... #end",
     "counts, the last number included",
     {"#for (I, 1, 5) sphere { <I - 3, 0.3, 0>, 0.3 } #end"}},
    {"while",
     "#while (condition) ... #end",
     "repeats; #break leaves the loop",
     {"#declare I = 0; #while (I < 5) sphere { <I - 2, 0.3, 0>, 0.3 } #declare I = I + 1; #end"}},
    {"break",
     "#break",
     "leaves a loop, a #switch or a macro",
     {"#for (I, 1, 9) #if (I > 5) #break #end sphere { <I - 3, 0.3, 0>, 0.3 } #end"}},
    {"switch case range",
     "#switch (value) #case (n) ... #range (low, high) ... #else ... #end",
     "goes on at the first case that fits and through the following ones, until #break",
     {"#declare Storeys = 3; #switch (Storeys) #case (1) box { 0, 1 } #break #range (2, 4) box { "
      "0, <1, 2, 1> } #break #else box { 0, 3 } #end"}},
    {"macro",
     "#macro Name(A, B) ... #end",
     "declares a macro, which is called as Name(1, 2) and stands for its text",
     {"#macro Pillar(Place) cylinder { Place, Place + 1.5*y, 0.2 } #end Pillar(-x) Pillar(x)"}},
    {"end",
     "#if (A) ... #end",
     "ends #if, #for, #while, #switch and #macro",
     {"#if (clock < 1) sphere { y, 1 } #end"}},
    {"include",
     "#include \"file\"",
     "reads another file in this place; searched in the folder of the including file, the scene's "
     "folder, the current folder, the folders of +L and the library",
     {"#include \"colors.inc\" sphere { y, 1 pigment { Orange } }"}},
    {"version",
     "#version 3.7;",
     "the version of POV-Ray's language that the scene is written for; before 3.7 some words mean "
     "something else",
     {"#version 3.7;"}},
    {"default",
     "#default { texture, pigment, finish or camera }",
     "what all objects below have, unless they have their own",
     {"#default { finish { ambient 0 diffuse 0.8 } } sphere { y, 1 }"}},
    {"debug warning error render statistics",
     "#debug concat(\"A is \", str(A, 0, 2), \"\\n\")",
     "print a message of the scene; #error also ends the run",
     {"#debug concat(\"the height is \", str(1.6, 0, 2), \"\\n\")"}},
    {"deprecated once",
     "#declare deprecated once \"reason\" Name = value;",
     "declares a name whose use gives a warning: each use, or with `once` the first",
     {"#declare deprecated once \"Tall has replaced it\" High = 2; #declare Tall = High;"}},
    {"fopen fclose read write append",
     "#fopen F \"file\" write #write (F, A, \", \") #fclose F",
     "open a file for read, write or append, and #read (F, A, B) what values are there; tables are "
     "read by read_csv",
     {"#fopen Table \"lamps.txt\" write #write (Table, 1, \",\", 2, \"\\n\") #fclose Table #fopen "
      "Table \"lamps.txt\" read #read (Table, A, B) #fclose Table"}},
    {"sint8 uint8 sint16be sint16le uint16be uint16le sint32be sint32le",
     "#write (F, uint8 A)",
     "the form of numbers in a file that is not text: with a sign or without, of so many bits, the "
     "most or the least significant byte first",
     {"#fopen Table \"lamps.bin\" write #write (Table, uint8 200, sint16le -5) #fclose Table"}},
    // transformations
    {"translate", "translate <x, y, z>", "moves", {"box { -0.5, 0.5 translate <0, 1, 0> }"}},
    {"rotate",
     "rotate <x, y, z>",
     "turns around the x axis, then y, then z, by so many degrees; positive angles turn as the "
     "fingers of the left hand curl around the axis",
     {"box { <-0.5, 0, -0.5>, <0.5, 1.5, 0.5> rotate 30*y }"}},
    {"scale",
     "scale <x, y, z>",
     "stretches from the origin; one number does so in all directions",
     {"sphere { y, 1 scale <1, 0.5, 1> }"}},
    {"matrix",
     "matrix <m00, m01, m02, m10, m11, m12, m20, m21, m22, m30, m31, m32>",
     "the images of the three axes, then that of the origin; the 12 numbers of the inverse may "
     "follow, as in dumps",
     {"box { -0.5, 0.5 matrix <1, 0, 0, 0.5, 1, 0, 0, 0, 1, 0, 0.5, 0> }"}},
    {"transform",
     "transform { translate v rotate v scale v matrix m ... [inverse] }",
     "transformations in their order, as one; it may be declared and used by name",
     {"#declare Tilt = transform { rotate 20*z translate 0.5*y } box { -0.5, 0.5 transform { Tilt "
      "} }"}},
    // objects
    {"object",
     "object { Name or object, modifiers }",
     "a declared object, or any other, with something more",
     {"#declare Bulb = sphere { 0, 0.3 } object { Bulb translate y }"}},
    {"union",
     "union { objects modifiers }",
     "several objects as one; its texture and other modifiers apply to all parts without their "
     "own",
     {"union { box { <-1, 0, -1>, <1, 0.4, 1> } sphere { 0.9*y, 0.6 } }"}},
    {"intersection difference",
     "difference { objects modifiers }",
     "an intersection is what is inside of all its objects; a difference is the first one without "
     "the others",
     {"difference { box { <-0.9, 0, -0.9>, <0.9, 1.6, 0.9> } sphere { <0, 1.6, -0.9>, 0.9 } rotate "
      "25*y }",
      "intersection { box { <-0.9, 0, -0.9>, <0.9, 1.8, 0.9> } sphere { 0.9*y, 1.15 } rotate 25*y "
      "}"}},
    {"merge",
     "merge { objects modifiers }",
     "a union without the surfaces that are hidden within it, for glass",
     {"merge { sphere { <-0.5, 0.9, 0>, 0.8 } sphere { <0.5, 0.9, 0>, 0.8 } }"}},
    {"split_union sturm", "union { ... split_union off }", "without effect"},
    {"replace",
     "model { file \"name\" replace \"material\" texture { ... } replace \"part\" object { ... } }",
     "a texture or material { } of the scene in the place of a material of the model, or an object "
     "in the place of a part",
     {"model { file \"lantern.gltf\" replace \"Iron\" texture { pigment { rgb <0.5, 0.1, 0.1> } "
      "} }",
      "model { file \"lantern.gltf\" replace \"Panes\" sphere { 0.2*y, 0.15 pigment { rgb 1 } "
      "finish { "
      "emission 3 } } }"}},
    {"light_group global_lights",
     "light_group { lights objects [global_lights on] }",
     "lights that shine on these objects only",
     {"light_group { light_source { <-2, 4, -3>, rgb 1 } sphere { y, 1 } global_lights on }"}},
    {"bounded_by clipped_by",
     "clipped_by { objects }",
     "cuts away what is outside of the given objects, and leaves the cut open; so does bounded_by "
     "where its bounds cut through the object",
     {"sphere { y, 1 clipped_by { plane { z, 0 } } }",
      "torus { 1, 0.3 translate 0.3*y bounded_by { box { <-1.4, 0, -1.4>, <1.4, 0.7, 1.4> } } }"}},
    {"looks_like projected_through",
     "light_source { ... looks_like { object } }",
     "the object that is seen in a light's place; or the one that the light has to pass",
     {"light_source { <0, 2, -1>, rgb 1 looks_like { sphere { 0, 0.1 pigment { rgb 1 } finish { "
      "ambient 1 } } } }",
      "light_source { <-2, 4, -3>, rgb 1 projected_through { disc { <-1, 2, -1.5>, y, 0.3 } } }"}},
    {"cutaway_textures",
     "difference { ... cutaway_textures }",
     "lets parts without a texture show the textures of the objects that they cut",
     {"difference { box { <-1, 0, -1>, <1, 1.5, 1> pigment { rgb <0.9, 0.5, 0.3> } } sphere { <0, "
      "1.5, -1>, 1 } cutaway_textures }"}},
    {"camera",
     "camera { type location v look_at v angle n ... }",
     "the type is the first word, and perspective when there is none: --help cameras",
     {"camera { location <0, 1.5, -5> look_at y angle 40 }"}},
    // appearance
    {"texture",
     "texture { pigment { ... } normal { ... } finish { ... } transformations }",
     "how a surface looks; several one after the other are layers, the last on top, and a pattern "
     "with texture_map blends some",
     {"texture { pigment { rgb <0.9, 0.6, 0.3> } finish { specular 0.4 } }"}},
    {"pigment",
     "pigment { colour }, pigment { pattern map modifiers transformations }",
     "the colour of a surface: --help patterns, --help pattern_modifiers",
     {"pigment { rgb <0.9, 0.6, 0.3> }",
      "pigment { bozo color_map { [0 rgb 1] [1 rgb <0.2, 0.4, 0.8>] } scale 0.3 }"}},
    {"normal",
     "normal { pattern depth modifiers transformations }",
     "bumps: the pattern is taken for a height, and tilts the surface as far as light goes",
     {"normal { bumps 0.8 scale 0.15 }"}},
    {"material",
     "material { texture { ... } interior_texture { ... } interior { ... } }",
     "how a surface, its inner side and its inside look",
     {"material { texture { pigment { rgbt 0.9 } } interior { ior 1.5 } }"}},
    {"interior_texture",
     "sphere { ... interior_texture { ... } }",
     "how the side looks that is seen from inside",
     {"sphere { y, 1 clipped_by { plane { y, 1 } } pigment { rgb 0.8 } interior_texture { pigment "
      "{ rgb <0.9, 0.2, 0.1> } } }"}},
    {"color_map colour_map",
     "color_map { [0 colour] [0.5 colour] [1 colour] }",
     "the colours of a pattern's values, and blends between them",
     {"pigment { marble color_map { [0 rgb 1] [0.6 rgb 0.8] [1 rgb 0.2] } scale 0.5 }",
      "pigment { wood colour_map { [0 rgb <0.6, 0.4, 0.2>] [1 rgb <0.3, 0.2, 0.1>] } scale 0.3 }"}},
    {"pigment_map normal_map texture_map slope_map",
     "pigment_map { [0 pigment] [1 pigment] }",
     "a map like color_map whose entries are whole pigments, normals or textures; entries of a "
     "slope_map are <height, slope>",
     {"pigment { gradient y pigment_map { [0.4 rgb 1] [0.6 checker scale 0.2] } scale 2 }",
      "texture { gradient y texture_map { [0.5 pigment { rgb 1 }] [0.5 pigment { rgb <0.8, 0.2, "
      "0.1> } finish { phong 1 }] } }",
      "normal { gradient y normal_map { [0.5 bumps 1 scale 0.1] [0.5 dents 1.5 scale 0.1] } }",
      "normal { gradient x 1 slope_map { [0 <0, 1>] [0.5 <1, 0>] [1 <0, -1>] } scale 0.3 }"}},
    {"rgb rgbf rgbt rgbft srgb srgbf srgbt srgbft color colour",
     "rgb <red, green, blue>",
     "a colour; f is the share of light that passes and takes on the colour, t that of light that "
     "passes unchanged; srgb takes values as displays know them",
     {"pigment { rgb <0.9, 0.6, 0.3> }", "pigment { srgb <246, 200, 150>/255 }",
      "pigment { color rgbt <0.9, 0.9, 1, 0.6> }"}},
    {"red green blue filter transmit alpha gray",
     "color red 1 green 0.5 filter 0.2, Colour.red",
     "one component of a colour, or its brightness",
     {"pigment { color red 1 green 0.5 filter 0.2 }",
      "#declare Warm = rgb <1, 0.6, 0.3>; sphere { y, 1 pigment { rgb Warm.red } }"}},
    {"all",
     "image_map { ... filter all 0.5 transmit all 0.2 }",
     "for all colours of a picture, or a number for one of its palette",
     {"pigment { image_map { png \"test.png\" transmit all 0.3 } }"}},
    {"density",
     "media { ... density { spherical color_map { ... } } }",
     "how dense a medium is from place to place: a pattern or a colour, as in a pigment; several "
     "are multiplied",
     {"media { emission 0.3 density { spherical color_map { [0 rgb 0] [1 rgb 1] } } }"}},
    {"density_map",
     "density { gradient y density_map { [0 rgb 0] [1 bozo] } }",
     "a map like pigment_map whose entries are densities",
     {"media { emission 0.3 density { gradient y density_map { [0 rgb 0] [1 bozo scale 0.3] } } "
      "}"}},
    {"warp",
     "pigment { ... warp { repeat x } }",
     "moves the points at which a pattern is evaluated: --help warps",
     {"pigment { checker warp { turbulence 0.4 } scale 0.3 }"}},
    {"texture_list",
     "mesh2 { ... texture_list { count, texture { ... }, ... } }",
     "the textures that the faces of a mesh choose from",
     {"mesh2 { vertex_vectors { 3, -x, x, 2*y } texture_list { 2, texture { pigment { rgb 1 } } "
      "texture { pigment { rgb <0.9, 0.5, 0.2> } } } face_indices { 1, <0, 1, 2>, 1 } }"}},
    {"tiles tile2",
     "texture { tiles { texture { ... } tile2 texture { ... } } }",
     "two textures in alternate squares, as in old scenes; `checker` replaces it",
     {"texture { tiles { texture { pigment { rgb 1 } } tile2 texture { pigment { rgb 0.2 } } } "
      "scale 0.3 }"}},
    {"reflection_exponent",
     "finish { reflection 0.5 reflection_exponent 1 }",
     "as exponent in the block: reflection { 0.5 exponent 1 }",
     {"finish { reflection 0.5 reflection_exponent 1 }"}},
    {"fade_colour",
     "interior { ... fade_colour rgb 0.5 }",
     "another spelling of fade_color",
     {"interior { ior 1.5 fade_distance 1 fade_power 1001 fade_colour rgb <0.2, 0.6, 0.3> }"}},
    {"uv_mapping",
     "pigment { uv_mapping image_map { ... } }",
     "the pattern lies on the surface's own coordinates instead of in space",
     {"pigment { uv_mapping checker scale 0.1 }"}},
    {"quick_color quick_colour",
     "pigment { ... quick_color rgb 1 }",
     "the colour at the qualities +Q0 to +Q5",
     {"pigment { bozo quick_color rgb <0.9, 0.6, 0.3> }",
      "pigment { bozo quick_colour rgb <0.9, 0.6, 0.3> }"}},
    // values
    {"array",
     "array[3] { 1, 2, 3 }, array[2][4]",
     "a list or table of values, counted from 0",
     {"#declare Heights = array[3] { 1, 1.4, 1.8 }; #for (I, 0, 2) box { <I - 1, 0, 0>, <I - 0.5, "
      "Heights[I], 0.5> } #end"}},
    {"function",
     "function(x, y, z) { x*x + y*y - 1 }, function { pattern { ... } }",
     "a function of numbers, for other expressions, isosurfaces and patterns",
     {"#declare Wave = function(x) { 0.3*sin(3*x) } sphere { <0, 1 + Wave(0.5), 0>, 0.5 }"}},
    {"spline",
     "spline { cubic_spline 0, <0, 0, 0>, 1, <1, 2, 0>, ... }",
     "a curve through points at times, called like a function: Path(0.5); also linear_spline, "
     "quadratic_spline and natural_spline",
     {"#declare Path = spline { cubic_spline -1, <-2, 0, 0>, 0, <-1.5, 0.4, 0>, 1, <0, 1.5, 0>, 2, "
      "<1.5, 0.4, 0>, 3, <2, 0, 0> } sphere { Path(0.5), 0.3 }"}},
    {"natural_spline",
     "spline { natural_spline 0, <0, 0, 0>, 1, <1, 2, 0>, ... }",
     "a curve without bends at its ends",
     {"#declare Path = spline { natural_spline 0, <-1.5, 0.4, 0>, 1, <0, 1.5, 0>, 2, <1.5, 0.4, 0> "
      "} sphere { Path(0.5), 0.3 }"}},
    {"defined",
     "#if (defined(Name))",
     "whether a name, or an element of an array, has a value",
     {"#if (!defined(Storeys)) #declare Storeys = 3; #end"}},
    {"now",
     "now",
     "the days since the year 2000, for datetime()",
     {"#debug concat(\"day \", str(now, 0, 0), \"\\n\")"}},
    {"pi", "pi", "3.14159...", {"sphere { <cos(pi/3), 1, sin(pi/3)>, 0.5 }"}},
    {"true yes on false no off",
     "on",
     "1, or 0",
     {"#declare Lit = true; #if (Lit = on) light_source { <-2, 4, -3>, rgb 1 } #end"}},
    {"x y z u v t",
     "3*x + y",
     "the vectors along the axes; the variables of functions",
     {"sphere { 2*x + y, 0.5 }"}},
    {"clock",
     "clock",
     "the time of an animation, from 0 to 1 by default: +K, +KI, +KF",
     {"sphere { <2*clock, 1, 0>, 0.5 }"}},
    {"frame_number initial_frame final_frame initial_clock final_clock clock_delta clock_on "
     "image_width image_height",
     "frame_number, image_width ...",
     "facts about the animation and the picture",
     {"#if (clock_on) sphere { <frame_number/10, 1, 0>, 0.5 } #end",
      "camera { location <0, 1.5, -5> look_at y right image_width/image_height*x }"}},
    // settings
    {"light_sampler",
     "global_settings { light_sampler { light_octree } }",
     "how luminaires are chosen at a point, as by --light-sampler: --help light_samplers",
     {"global_settings { light_sampler { light_octree } }"}},
    {"luminaires",
     "global_settings { luminaires above 0.5 }",
     "which glowing objects light their surroundings: all with an emission (the default), "
     "`luminaires above` a radiance, `luminaires none`, or `luminaires ambient`: also objects with "
     "an ambient of 1 or more, as in old scenes",
     {"global_settings { luminaires above 0.5 }"}},
    {"integrator",
     "global_settings { integrator { path_traced } }",
     "how light is followed, as --integrator: --help integrators",
     {"global_settings { integrator { path_traced } }"}},
    {"index",
     "global_settings { index { kd_tree } }",
     "finds the surfaces that rays meet, as --index: --help indexes",
     {"global_settings { index { kd_tree } }"}},
    {"background",
     "background { colour }",
     "what rays see that meet nothing",
     {"background { rgb <0.1, 0.15, 0.3> }"}},
    {"charset ascii utf8 sys", "global_settings { charset utf8 }",
     "without effect: strings are UTF-8"},
    {"hf_gray_16 max_intersections", "global_settings { hf_gray_16 on }", "without effect"},
    // not available in this version
    {"albedo",
     "finish { diffuse albedo 0.5 }",
     "amounts as shares of all light",
     {"finish { diffuse albedo 0.5 }"}},
    {"anisotropy", "finish { anisotropy 0.5 }", "not available in Candelabra"},
    {"iff", "image_map { iff \"x.iff\" }", "a kind of pictures that is not available"},
    {"composite",
     "composite { objects }",
     "the name of a union in the oldest scenes",
     {"composite { sphere { y, 1 } box { 0, 1 } }"}},
    {"dtag", "object { ... dtag }", "without effect"},
    {"steps", "photons { ... }", "a word of old versions, which photons do not have any more"},
    {"importance", "radiosity { ... }", "without effect in Candelabra"},
});

bool has_word(std::string_view words, std::string_view word) {
    while (!words.empty())
        if (take_until(words, " ") == word) return true;
    return false;
}

}  // namespace

std::span<const GlossaryEntry> glossary() { return entries; }

bool says_available(std::string_view help) { return help.find("not available") == help.npos; }

const GlossaryEntry* glossary_entry(std::string_view word) {
    if (word.starts_with('#')) word.remove_prefix(1);
    const auto found = std::ranges::find_if(
        entries, [&](const GlossaryEntry& entry) { return has_word(entry.words, word); });
    return found == entries.end() ? nullptr : &*found;
}

}  // namespace candelabra
