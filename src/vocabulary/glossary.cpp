// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/glossary.h"

#include "text/ascii.h"

#include <algorithm>
#include <array>

namespace candelabra {

namespace {

constexpr auto entries = std::to_array<GlossaryEntry>({
    // directives
    {"declare", "#declare Name = value;",
     "gives a name to a number, vector, colour, string, array, function, object, texture or other "
     "part of a scene, until the end, everywhere"},
    {"local", "#local Name = value;", "declares a name for the rest of the macro or included file"},
    {"undef", "#undef Name", "takes a name away"},
    {"if elseif else", "#if (condition) ... #elseif (condition) ... #else ... #end",
     "chooses; any number but 0 is true"},
    {"ifdef ifndef", "#ifdef(Name) ... #else ... #end", "tests whether a name is declared, or not"},
    {"for", "#for (Name, first, last[, step]) ... #end", "counts, the last number included"},
    {"while", "#while (condition) ... #end", "repeats; #break leaves the loop"},
    {"break", "#break", "leaves a loop, a #switch or a macro"},
    {"switch case range", "#switch (value) #case (n) ... #range (low, high) ... #else ... #end",
     "goes on at the first case that fits and through the following ones, until #break"},
    {"macro", "#macro Name(A, B) ... #end",
     "declares a macro, which is called as Name(1, 2) and stands for its text"},
    {"end", "#if (A) ... #end", "ends #if, #for, #while, #switch and #macro"},
    {"include", "#include \"file\"",
     "reads another file in this place; searched in the folder of the including file, the scene's "
     "folder, the current folder, the folders of +L and the library"},
    {"version", "#version 3.7;",
     "the version of POV-Ray's language that the scene is written for; before 3.7 some words mean "
     "something else"},
    {"default", "#default { texture, pigment, finish or camera }",
     "what objects have from here on when nothing else is said"},
    {"debug warning error render statistics", "#debug concat(\"A is \", str(A, 0, 2), \"\\n\")",
     "tell something to whoever renders the scene; #error ends it"},
    {"deprecated once", "#declare deprecated once \"say why\" Name = value;",
     "declares a name whose use gives a warning: each use, or with `once` the first"},
    {"fopen fclose read write append", "#fopen F \"file\" write #write (F, A, \", \") #fclose F",
     "open a file for read, write or append, and #read (F, A, B) what values are there; tables are "
     "read by read_csv"},
    {"sint8 uint8 sint16be sint16le uint16be uint16le sint32be sint32le", "#write (F, uint8 A)",
     "the form of numbers in a file that is not text: with a sign or without, of so many bits, the "
     "most or the least significant byte first"},
    // transformations
    {"translate", "translate <x, y, z>", "moves"},
    {"rotate", "rotate <x, y, z>",
     "turns around the x axis, then y, then z, by so many degrees; positive angles turn as the "
     "fingers of the left hand curl around the axis"},
    {"scale", "scale <x, y, z>", "stretches from the origin; one number does so in all directions"},
    {"matrix", "matrix <m00, m01, m02, m10, m11, m12, m20, m21, m22, m30, m31, m32>",
     "the images of the three axes, then that of the origin; the 12 numbers of the inverse may "
     "follow, as in dumps"},
    {"transform", "transform { translate v rotate v scale v matrix m ... [inverse] }",
     "transformations in their order, as one; it may be declared and used by name"},
    // objects
    {"object", "object { Name or object, modifiers }",
     "a declared object, or any other, with something more"},
    {"union", "union { objects modifiers }",
     "several objects as one; its texture and other modifiers apply to all parts without their "
     "own"},
    {"intersection difference", "difference { objects modifiers }",
     "an intersection is what is inside of all its objects; a difference is the first one without "
     "the others"},
    {"merge", "merge { objects modifiers }",
     "a union without the surfaces that are hidden within it, for glass"},
    {"split_union sturm", "union { ... split_union off }", "without effect"},
    {"light_group global_lights", "light_group { lights objects [global_lights on] }",
     "lights that shine on these objects only"},
    {"bounded_by clipped_by", "clipped_by { objects }",
     "cuts away what is outside of the given objects, and leaves the cut open; so does bounded_by "
     "where its bounds cut through the object"},
    {"looks_like projected_through", "light_source { ... looks_like { object } }",
     "the object that is seen in a light's place; or the one that the light has to pass"},
    {"no_shadow no_image no_reflection no_radiosity", "sphere { ... no_shadow }",
     "an object that throws no shadow, that the camera does not see, that mirrors do not see, or "
     "that "
     "reflects no light to others"},
    {"no_luminaire", "sphere { ... no_luminaire }",
     "an object that glows, but lights nothing; in a finish: its emission does not"},
    {"hollow inverse double_illuminate", "sphere { ... hollow }",
     "the inside is empty; inside and outside are exchanged; light on the back counts as well"},
    {"cutaway_textures", "difference { ... cutaway_textures }",
     "lets parts without a texture show the textures of the objects that they cut"},
    {"camera", "camera { type location v look_at v angle n ... }",
     "the type is the first word, and perspective when there is none: --help cameras"},
    // appearance
    {"texture", "texture { pigment { ... } normal { ... } finish { ... } transformations }",
     "how a surface looks; several one after the other are layers, the last on top, and a pattern "
     "with texture_map blends some"},
    {"pigment", "pigment { colour }, pigment { pattern map modifiers transformations }",
     "the colour of a surface: --help patterns, --help pattern_modifiers"},
    {"normal", "normal { pattern depth modifiers transformations }",
     "bumps: the pattern is taken for a height, and tilts the surface as far as light goes"},
    {"material", "material { texture { ... } interior_texture { ... } interior { ... } }",
     "how a surface, its inner side and its inside look"},
    {"interior_texture", "sphere { ... interior_texture { ... } }",
     "how the side looks that is seen from inside"},
    {"color_map colour_map", "color_map { [0 colour] [0.5 colour] [1 colour] }",
     "the colours of a pattern's values, and blends between them"},
    {"pigment_map normal_map texture_map slope_map", "pigment_map { [0 pigment] [1 pigment] }",
     "a map like color_map whose entries are whole pigments, normals or textures; entries of a "
     "slope_map are <height, slope>"},
    {"rgb rgbf rgbt rgbft srgb srgbf srgbt srgbft color colour", "rgb <red, green, blue>",
     "a colour; f is the share of light that passes and takes on the colour, t that of light that "
     "passes unchanged; srgb takes values as displays know them"},
    {"red green blue filter transmit alpha gray", "color red 1 green 0.5 filter 0.2, Colour.red",
     "one component of a colour, or its brightness"},
    {"all", "image_map { ... filter all 0.5 transmit all 0.2 }",
     "for all colours of a picture, or a number for one of its palette"},
    {"density", "media { ... density { spherical color_map { ... } } }",
     "how dense a medium is from place to place: a pattern or a colour, as in a pigment; several "
     "are multiplied"},
    {"density_map", "density { gradient y density_map { [0 rgb 0] [1 bozo] } }",
     "a map like pigment_map whose entries are densities"},
    {"warp", "pigment { ... warp { repeat x } }",
     "moves the points at which a pattern is evaluated: --help warps"},
    {"texture_list", "mesh2 { ... texture_list { count, texture { ... }, ... } }",
     "the textures that the faces of a mesh choose from"},
    {"tiles tile2", "texture { tiles { texture { ... } tile2 texture { ... } } }",
     "two textures in alternate squares, as in old scenes; `checker` replaces it"},
    {"reflection_exponent", "finish { reflection 0.5 reflection_exponent 1 }",
     "as exponent in the block: reflection { 0.5 exponent 1 }"},
    {"fade_colour", "interior { ... fade_colour rgb 0.5 }", "another spelling of fade_color"},
    {"uv_mapping", "pigment { uv_mapping image_map { ... } }",
     "the pattern lies on the surface's own coordinates instead of in space"},
    {"quick_color quick_colour", "pigment { ... quick_color rgb 1 }",
     "the colour at the qualities +Q0 to +Q5"},
    // values
    {"array", "array[3] { 1, 2, 3 }, array[2][4]", "a list or table of values, counted from 0"},
    {"function", "function(x, y, z) { x*x + y*y - 1 }, function { pattern { ... } }",
     "a function of numbers, for other expressions, isosurfaces and patterns"},
    {"spline", "spline { cubic_spline 0, <0, 0, 0>, 1, <1, 2, 0>, ... }",
     "a curve through points at times, called like a function: Path(0.5); also linear_spline, "
     "quadratic_spline and natural_spline"},
    {"natural_spline", "spline { natural_spline 0, <0, 0, 0>, 1, <1, 2, 0>, ... }",
     "a curve without bends at its ends"},
    {"defined", "#if (defined(Name))", "whether a name, or an element of an array, has a value"},
    {"now", "now", "the days since the year 2000, for datetime()"},
    {"pi", "pi", "3.14159..."},
    {"true yes on false no off", "on", "1, or 0"},
    {"x y z u v t", "3*x + y", "the vectors along the axes; the variables of functions"},
    {"clock", "clock", "the time of an animation, from 0 to 1 when nothing is said: +K, +KI, +KF"},
    {"frame_number initial_frame final_frame initial_clock final_clock clock_delta clock_on "
     "image_width image_height",
     "frame_number, image_width ...", "facts about the animation and the picture"},
    // settings
    {"light_sampler", "global_settings { light_sampler { light_octree } }",
     "how luminaires are chosen at a point, as by --light-sampler: --help light_samplers"},
    {"luminaires", "global_settings { luminaires above 0.5 }",
     "which glowing objects light their surroundings: all with an emission (the default), "
     "`luminaires above` a radiance, `luminaires none`, or `luminaires ambient`: also objects with "
     "an ambient of 1 or more, as in old scenes"},
    {"integrator", "global_settings { integrator { path_traced } }",
     "how light is followed, as --integrator: --help integrators"},
    {"index", "global_settings { index { kd_tree } }",
     "finds the surfaces that rays meet, as --index: --help indexes"},
    {"background", "background { colour }", "what rays see that meet nothing"},
    {"charset ascii utf8 sys", "global_settings { charset utf8 }",
     "without effect: strings are UTF-8"},
    {"hf_gray_16 max_intersections", "global_settings { hf_gray_16 on }", "without effect"},
    // not available in this version
    {"albedo", "finish { diffuse albedo 0.5 }", "amounts as shares of all light"},
    {"anisotropy", "finish { anisotropy 0.5 }", "not available in Candelabra"},
    {"iff", "image_map { iff \"x.iff\" }", "a kind of pictures that is not available"},
    {"composite", "composite { objects }", "the name of a union in the oldest scenes"},
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
