// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/samples.h"

#include <algorithm>
#include <array>

namespace candelabra::proof {

namespace {

struct Sample {
    std::string_view item, values;
};

constexpr auto whole_items = std::to_array<Sample>({
    {"bicubic_patch",
     "type 1 flatness 0.01 u_steps 3 v_steps 3 uv_vectors <0, 0> <1, 0> <1, 1> <0, 1> "
     "<-0.8, -0.6, 0>, <-0.3, -0.8, -0.5>, <0.3, -0.8, -0.5>, <0.8, -0.6, 0>, "
     "<-0.9, -0.2, -0.4>, <-0.3, -0.2, -0.9>, <0.3, -0.2, -0.9>, <0.9, -0.2, -0.4>, "
     "<-0.9, 0.2, -0.4>, <-0.3, 0.2, -0.9>, <0.3, 0.2, -0.9>, <0.9, 0.2, -0.4>, "
     "<-0.8, 0.6, 0>, <-0.3, 0.8, -0.5>, <0.3, 0.8, -0.5>, <0.8, 0.6, 0>"},
    {"blob",
     "threshold 0.5 sphere { <-0.4, 0, 0>, 0.9, 1 } component 0.6, 0.7, <0, -0.6, 0.2> cylinder { "
     "<0.3, -0.5, 0>, <0.3, 0.5, 0>, 0.6, "
     "1 }"},
    {"box", "<-0.7, -0.6, -0.5>, <0.6, 0.7, 0.6>"},
    {"cone", "<0, -0.7, 0>, 0.7, <0, 0.7, 0>, 0.25"},
    {"cylinder", "<0, -0.7, 0>, <0, 0.6, 0>, 0.55"},
    {"disc", "0, <0.3, 0.2, -1>, 0.8, 0.2"},
    {"cubic",
     "<1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, -0.4> clipped_by { sphere { 0, 0.9 "
     "} }"},
    {"height_field",
     "function 8, 8 { 0.5*x*y + 0.3*sin(7*x) } ~smooth|water_level 0.1|hierarchy off|~ translate "
     "<-0.5, -0.2, -0.5> scale 1.6"},
    {"isosurface",
     "function { x*x + y*y + z*z - 0.5 + 0.2*sin(4*x) } contained_by { box { -1, 1 } }"},
    {"julia_fractal",
     // A place in a set of a formula costs a hundred times that of another shape: few scenes have
     // one.
     "<-0.083, 0, -0.83, -0.025> ~quaternion sqr|quaternion cube|quaternion sqr|quaternion cube|"
     "quaternion sqr|quaternion cube|quaternion sqr|quaternion cube|quaternion sqr|"
     "quaternion cube|quaternion sqr|quaternion cube|quaternion sqr|quaternion cube|"
     "quaternion sqr|quaternion cube|hypercomplex exp|hypercomplex ln|"
     "hypercomplex reciprocal|hypercomplex sin|hypercomplex asin|hypercomplex sinh|"
     "hypercomplex asinh|hypercomplex cos|hypercomplex acos|hypercomplex cosh|"
     "hypercomplex acosh|hypercomplex tan|hypercomplex atan|hypercomplex tanh|"
     "hypercomplex atanh|hypercomplex pwr <2, 0>~ max_iteration 2 precision 3 "
     "~slice <0, 0.1, 0, 1>, 0.1|~"},
    {"lathe", "linear_spline 5, <0, -0.7>, <0.6, -0.6>, <0.3, 0>, <0.6, 0.5>, <0, 0.7>"},
    {"mesh",
     "triangle { <-0.8, -0.6, -0.5>, <0.8, -0.6, -0.5>, <0, 0.8, 0> } "
     "triangle { <0.8, -0.6, -0.5>, <0, -0.6, 0.8>, <0, 0.8, 0> } "
     "triangle { <0, -0.6, 0.8>, <-0.8, -0.6, -0.5>, <0, 0.8, 0> } "
     "triangle { <-0.8, -0.6, -0.5>, <0, -0.6, 0.8>, <0.8, -0.6, -0.5> } inside_vector y"},
    {"mesh2",
     "vertex_vectors { 4, <-0.9, -0.7, -0.9>, <0.9, -0.7, -0.9>, <0, -0.7, 0.9>, <0, 0.9, 0> } "
     "normal_vectors { 4, <-1, -0.5, -1>, <1, -0.5, -1>, <0, -0.5, 1>, y } "
     "uv_vectors { 3, <0, 0>, <1, 0>, <0, 1> } "
     "face_indices { 4, <0, 1, 3>, <1, 2, 3>, <2, 0, 3>, <0, 2, 1> } "
     "normal_indices { 4, <0, 1, 3>, <1, 2, 3>, <2, 0, 3>, <0, 2, 1> } "
     "uv_indices { 4, <0, 1, 2>, <0, 1, 2>, <0, 1, 2>, <0, 2, 1> } inside_vector y"},
    {"model",
     "~file \"gem.obj\"|file \"gems.gltf\" part \"Pair\"|file \"gems.gltf\" part \"Pair\" replace "
     "\"Painted\" texture { pigment { rgb 0.6 } }|file \"gems.gltf\" part \"Pair\" replace \"Gem\" "
     "sphere { 0, 0.8 }~"},
    {"ovus", "0.6, 0.4"},
    {"parametric",
     "function { 0.7*cos(u)*cos(v) } function { 0.7*sin(v) } function { 0.7*sin(u)*cos(v) } "
     "<0, -1.5>, <6.2, 1.5>"},
    {"plane", "<0.1, 1, -0.05>, -0.6"},
    {"poly", "2, <1, 0, 0, 0, 1, 0, 0, 1, 0, -0.5> clipped_by { box { -0.9, 0.9 } }"},
    {"polygon", "5, <-0.7, -0.6>, <0.7, -0.6>, <0.5, 0.7>, <-0.6, 0.6>, <-0.7, -0.6>"},
    {"polynomial",
     "4, xyz(4, 0, 0): 1, xyz(0, 4, 0): 1, xyz(0, 0, 4): 1, xyz(0, 0, 0): -0.3 clipped_by { box { "
     "-0.9, 0.9 } }"},
    {"prism",
     "~linear_sweep|conic_sweep|~ "
     "~linear_spline -0.6, 0.6, 5, <-0.6, -0.5>, <0.6, -0.5>, <0.4, 0.6>, <-0.5, 0.5>, "
     "<-0.6, -0.5>|"
     "quadratic_spline -0.6, 0.6, 6, <-0.5, 0.5>, <-0.6, -0.5>, <0.6, -0.5>, <0.4, 0.6>, "
     "<-0.5, 0.5>, <-0.6, -0.5>|"
     "cubic_spline -0.6, 0.6, 7, <-0.5, 0.5>, <-0.6, -0.5>, <0.6, -0.5>, <0.4, 0.6>, "
     "<-0.5, 0.5>, <-0.6, -0.5>, <0.6, -0.5>|"
     "bezier_spline -0.6, 0.6, 8, <-0.6, 0>, <-0.6, 0.5>, <0.6, 0.5>, <0.6, 0>, "
     "<0.6, 0>, <0.6, -0.5>, <-0.6, -0.5>, <-0.6, 0>~ ~open|sturm|~"},
    {"quadric", "<1, 1.5, 1>, <0.2, 0, 0>, <0, 0.1, 0>, -0.5"},
    {"quartic",
     "<1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, "
     "1, 0, 0, 0, -0.3> clipped_by { box { -0.9, 0.9 } }"},
    {"smooth_triangle",
     "<-0.8, -0.6, 0>, <-0.3, -0.2, -1>, <0.8, -0.6, 0>, <0.3, -0.2, -1>, <0, 0.8, 0.3>, "
     "<0, 0.4, -1>"},
    {"sor", "5, <0.3, -1>, <0.5, -0.7>, <0.3, 0>, <0.5, 0.6>, <0.2, 1>"},
    {"sphere", "<0.1, 0, -0.1>, 0.7"},
    {"sphere_sweep",
     "~linear_spline 3, <-0.5, -0.3, 0>, 0.3, <0.1, 0.4, 0.2>, 0.25, <0.5, -0.2, -0.1>, 0.35|"
     "cubic_spline 4, <-0.9, -0.3, 0>, 0.3, <-0.4, 0.3, 0.2>, 0.25, <0.4, -0.2, -0.1>, 0.35, "
     "<0.9, 0.2, 0>, 0.2|"
     "b_spline 5, <-0.9, -0.3, 0>, 0.3, <-0.4, 0.3, 0.2>, 0.25, <0.4, -0.2, -0.1>, 0.35, "
     "<0.7, 0.2, 0>, 0.2, <0.9, 0.4, 0>, 0.2~ tolerance 0.01"},
    {"superellipsoid", "<0.5, 1.4> scale 0.75"},
    {"text", "~ttf \"timrom.ttf\"|internal 1~ \"Ea\", 0.4, 0 translate -0.3 scale 1.3"},
    {"torus", "0.5, 0.25 rotate 50*x"},
    {"triangle", "<-0.8, -0.6, 0>, <0.8, -0.6, 0>, <0, 0.8, 0.3>"},
    {"image_map",
     "{ ~png \"wide.png\"|\"gems.gltf\" picture 0~ ~|tint <0.9, 0.5, 0.7> alpha_cutoff 0.5~ "
     "~|once|map_type 1|map_type 2|interpolate 2|gamma 1.5|use_index|use_alpha off|use_color|"
     "use_colour|premultiplied off~ }"},
    {"image_pattern",
     "{ png \"wide.png\" ~|once|map_type 1|map_type 2|interpolate 2|gamma 1.5|use_index|use_alpha "
     "off|"
     "use_color|use_colour|premultiplied off~ }"},
    {"bump_map", "{ png \"wide.png\" ~bump_size 2|tangent_space~ }"},
    {"object", "{ sphere { 0, 0.6 } }"},
    {"pigment_pattern", "{ bozo scale 0.5 }"},
    {"function", "{ x*x - 0.5*y + 0.3*sin(5*z) }"},
    {"gradient", "<1, 0.4, 0.2>"},
    {"slope", "<0.3, 1, 0.2>"},
    {"mandel", "20"},
    {"julia", "<0.3, 0.2>, 15"},
    {"magnet", "1 mandel 20"},
    {"repeat", "0.6*x"},
    {"irid", "0.3 thickness 0.4 turbulence 0.1"},
});

struct WordSample {
    std::string_view item, word, value;
};

constexpr auto word_values = std::to_array<WordSample>({
    {"crackle", "metric", "2"},
    {"facets", "coords", "0.4"},
    {"pavement", "number_of_sides", "4"},
    {"pavement", "number_of_tiles", "3"},
    {"pavement", "pattern", "1"},
    {"pavement", "form", "1"},
    {"pattern", "noise_generator", "3"},
    {"finish", "phong_size", "20"},
    {"finish", "roughness", "0.05"},
    {"finish", "brilliance", "1.5"},
    {"finish", "crand", "0.1"},
    {"finish", "ior", "1.2"},
    {"interior", "ior", "1.4"},
    {"interior", "fade_power", "2"},
    {"interior", "dispersion", "1.1"},
    {"interior", "dispersion_samples", "5"},
    {"reflection", "exponent", "0.8"},
    {"light_source", "tightness", "5"},
    {"film", "white_balance", "4000"},
    {"film", "contrast", "1.2"},
    {"film", "saturation", "0.8"},
    {"film", "key", "0.1"},
    {"film", "response", "agx"},
    {"film", "pixel_filter", "triangle"},
    {"media", "intervals", "2"},
    {"media", "samples", "3"},
    {"warp", "strength", "0.5"},
    {"global_settings", "max_trace_level", "8"},
});

/// Words of files, of newer versions of the language, or that change what the values mean.
constexpr auto omitted = std::to_array<Sample>({
    {"mesh", "file"},
    {"mesh2", "*"},
    {"bicubic_patch", "*"},
    {"polynomial", "*"},
    {"sphere_sweep", "*"},
    {"prism", "*"},
    {"lathe", "*"},
    {"isosurface", "threshold"},
    {"isosurface", "polarity"},
    {"height_field", "*"},
    {"text", "*"},
    {"julia_fractal", "*"},
    {"density_file", "*"},
    {"image_map", "*"},
    {"image_pattern", "*"},
    {"bump_map", "*"},
    {"magnet", "*"},
    {"pavement", "exterior"},
    {"pavement", "interior"},
    {"finish", "emission"},
    {"finish", "ambient"},
    {"finish", "no_luminaire"},
    {"interior", "luminaire"},
    {"finish", "caustics"},
});

}  // namespace

std::string_view sample(std::string_view item) {
    const auto found = std::ranges::find(whole_items, item, &Sample::item);
    return found == whole_items.end() ? std::string_view() : found->values;
}

std::string_view sample(std::string_view item, std::string_view field) {
    for (const WordSample& each : word_values)
        if (each.item == item && each.word == field) return each.value;
    return {};
}

bool left_out(std::string_view item, std::string_view field) {
    return std::ranges::any_of(omitted, [&](const Sample& each) {
        return each.item == item && (each.values == field || each.values == "*");
    });
}

}  // namespace candelabra::proof
