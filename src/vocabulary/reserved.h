// SPDX-License-Identifier: GPL-3.0-or-later
// The reserved words as a compile-time table, and own words behind them. Names holds them first and
// in this order, so their numbers are constants, and `element.word == "pigment"_word` compares two
// numbers.
#pragma once

#include "text/ascii.h"
#include "vocabulary/words.h"

#include <algorithm>
#include <array>

namespace candelabra {

namespace reserved_detail {

struct Group {
    WordClass word_class;
    std::string_view spellings;
};

inline constexpr auto groups = std::array{
    Group{WordClass::word,
          "aa_level aa_threshold absorption accuracy adaptive adc_bailout agate agate_turb albedo "
          "all "
          "all_intersections altitude always_sample ambient ambient_light angle anisotropy aoi "
          "aperture arc_angle "
          "area_illumination area_light ascii assumed_gamma autostop average b_spline background "
          "bezier_spline "
          "bicubic_patch black_hole blob blur_samples bmp bokeh bounded_by box boxed bozo brick "
          "brick_size "
          "brightness brilliance bump_map bump_size bumps camera caustics cells charset checker "
          "circular clipped_by "
          "collect color_map colour_map component composite cone confidence conic_sweep "
          "conserve_energy "
          "contained_by control0 control1 coords count crackle crand cube cubic cubic_spline "
          "cubic_wave "
          "cutaway_textures cylinder cylindrical density density_file density_map dents df3 "
          "difference diffuse "
          "direction disc dispersion dispersion_samples dist_exp distance double_illuminate dtag "
          "eccentricity "
          "emission error_bound evaluate expand_thresholds exponent exr exterior extinction "
          "face_indices facets "
          "fade_color fade_colour fade_distance fade_power falloff falloff_angle finish fisheye "
          "flatness flip "
          "focal_point fog fog_alt fog_offset fog_type form frequency fresnel gamma gather gif "
          "global_lights "
          "global_settings gradient granite gray gray_threshold hdr height_field hexagon "
          "hf_gray_16 hierarchy "
          "hollow hypercomplex iff image_map image_pattern importance inside_vector interior "
          "interior_texture "
          "internal interpolate intersection intervals inverse ior irid irid_wavelength isosurface "
          "jitter jpeg "
          "julia julia_fractal lambda lathe leopard light_group light_source linear_spline "
          "linear_sweep load_file "
          "location look_at looks_like low_error_factor magnet major_radius mandel map_type marble "
          "material "
          "material_map matrix max_gradient max_intersections max_iteration max_sample max_trace "
          "max_trace_level "
          "maximum_reuse media media_attenuation media_interaction merge mesh mesh2 mesh_camera "
          "metallic method "
          "metric minimum_reuse mm_per_unit mortar natural_spline nearest_count no_bump_scale "
          "no_image no_radiosity "
          "no_reflection no_shadow noise_generator normal normal_indices normal_map normal_vectors "
          "number_of_sides "
          "number_of_tiles number_of_waves object octaves offset omega omnimax onion open orient "
          "orientation "
          "orthographic ovus panoramic parallel parametric pass_through pattern pavement "
          "perspective pgm phase "
          "phong phong_size photons pigment pigment_map pigment_pattern planar plane png point_at "
          "poly poly_wave "
          "polygon polynomial pot ppm precision precompute premultiplied pretrace_end "
          "pretrace_start prism "
          "projected_through pwr quadratic_spline quadric quartic quaternion quick_color "
          "quick_colour quilted "
          "radial radiosity radius rainbow ramp_wave ratio reciprocal recursion_limit reflection "
          "reflection_exponent refraction repeat right ripples rotate roughness samples save_file "
          "scale "
          "scallop_wave scattering shadowless sine_wave sint16be sint16le sint32be sint32le sint8 "
          "size sky "
          "sky_sphere slice slope slope_map smooth smooth_triangle solid sor spacing specular "
          "sphere sphere_sweep "
          "spherical spiral1 spiral2 spline split_union spotlight spotted sqr square steps "
          "strength sturm "
          "subsurface superellipsoid sys target text texture_list texture_map tga thickness "
          "threshold tiff "
          "tightness tile2 tiles tiling tolerance toroidal torus transform translate translucency "
          "triangle "
          "triangle_wave triangular ttf turb_depth turbulence type u_steps uint16be uint16le uint8 "
          "ultra_wide_angle "
          "union up use_alpha use_color use_colour use_index utf8 uv_indices uv_mapping uv_vectors "
          "v_steps variance "
          "vertex_vectors warp water_level waves width wood wrinkles xyz"},
    Group{WordClass::unary_function,
          "abs acos acosh asc asin asinh atan atanh ceil chr cos cosh degrees exp floor int ln log "
          "radians rand "
          "seed sin sinh sqrt strlen strlwr strupr tan tanh val vlength vnormalize"},
    Group{WordClass::function,
          "atan2 bitwise_and bitwise_or bitwise_xor concat datetime defined dimension_size "
          "dimensions div "
          "file_exists inside max max_extent min min_extent mod pow prod select str strcmp substr "
          "sum trace "
          "vaxis_rotate vcross vdot vrotate vstr vturbulence"},
    Group{WordClass::constant,
          "clock clock_on false no now off on pi t true u v version x y yes z"},
    Group{WordClass::colour, "color colour"},
    Group{WordClass::colour_prefix, "rgb rgbf rgbft rgbt srgb srgbf srgbft srgbt"},
    Group{WordClass::channel, "alpha blue filter green red transmit"},
    Group{WordClass::array, "array"},
    Group{WordClass::function_literal, "function"},
    Group{WordClass::layer, "texture"},
    Group{WordClass::directive,
          "append break case debug declare default deprecated else elseif end error fclose fopen "
          "for if ifdef "
          "ifndef include local macro once range read render statistics switch undef warning while "
          "write"},
};

/// Words of this language alone that make objects. Scenes may declare them.
inline constexpr auto own_words = std::array<std::string_view, own_word_count>{"model"};

constexpr std::size_t count_words() {
    std::size_t count = 0;
    for (const Group& group : groups) {
        ++count;
        for (const char c : group.spellings) count += c == ' ';
    }
    return count;
}

inline constexpr auto words = [] {
    std::array<Word, count_words()> result{};
    std::size_t n = 0;
    for (const Group& group : groups) {
        std::string_view rest = group.spellings;
        while (!rest.empty()) result[n++] = {take_until(rest, " "), group.word_class};
    }
    return result;
}();

static_assert(words.size() == reserved_word_count);

}  // namespace reserved_detail

/// The number of a reserved word in every Names table; no_name for other spellings.
constexpr NameId reserved_word(std::string_view spelling) {
    for (std::size_t i = 0; i < reserved_detail::words.size(); ++i)
        if (reserved_detail::words[i].spelling == spelling) return NameId(i);
    return no_name;
}

/// The same for an own word.
constexpr NameId own_word(std::string_view spelling) {
    for (std::size_t i = 0; i < reserved_detail::own_words.size(); ++i)
        if (reserved_detail::own_words[i] == spelling) return NameId(reserved_word_count + i);
    return no_name;
}

/// The number of a reserved or own word; other spellings do not compile.
consteval NameId operator""_word(const char* spelling, std::size_t length) {
    const NameId reserved = reserved_word({spelling, length});
    const NameId found = reserved == no_name ? own_word({spelling, length}) : reserved;
    if (found == no_name) throw "this word has no number of its own";
    return found;
}

}  // namespace candelabra
