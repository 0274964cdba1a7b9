// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/rendered_ranges.h"

#include "scene/scene.h"
#include "vocabulary/kinds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace candelabra {

namespace {

/// Each was tried with POV-Ray 3.7. Below an excluded end counts what is near to it, or what has no
/// effect.
constexpr auto rendered_ranges = std::to_array<RenderedRange>({
    {"torus", "major", 0, true},
    {"torus", "minor", 0},
    {"superellipsoid", "exponents", 1e-3},
    {"sphere_sweep", "tolerance", 1e-6},
    {"blob", "threshold", 1e-6},
    {"bicubic_patch", "flatness", 0},
    {"julia_fractal", "max_iteration", 1},
    {"julia_fractal", "precision", 1},
    {"finish", "roughness", 1e-4},
    {"finish", "ior", 0},
    {"finish", "refraction", 0},
    {"reflection", "exponent", 1e-6},
    {"interior", "ior", 0},
    {"interior", "fade_distance", 0},
    {"interior", "fade_power", 0},
    {"interior", "dispersion", 1},
    {"interior", "dispersion_samples", 2},
    {"fog", "away", 0},
    {"fog", "fog_type", 1},
    {"fog", "distance", 0},
    {"fog", "octaves", 1},
    {"media", "variance", 0},
    {"media", "ratio", 0},
    {"camera", "aperture", 0, true},
    {"camera", "variance", 0.0001, false, true},
    {"camera", "confidence", 0.9, false, true},
    {"light_source", "adaptive", 0},
    {"julia", "iterations", 0},
    {"julia", "exponent", 2, false, true},
    {"mandel", "iterations", 0},
    {"mandel", "exponent", 2, false, true},
    {"magnet", "mandel", 0},
    {"magnet", "julia_iterations", 0},
    {"spiral1", "arms", 0, false, false, 65536},
    {"spiral2", "arms", 0, false, false, 65536},
    {"black_hole", "radius", 1e-6, true},
    {"bump_map", "interpolate", 0, false, true},
    {"normal", "accuracy", 1e-6, true},
    {"scattering", "eccentricity", -1},
    {"bicubic_patch", "u_steps", 0},
    {"bicubic_patch", "v_steps", 0},
    {"subsurface", "samples", 0},
    {"subsurface", "single_samples", 0},
    {"photons", "max_trace_level", 5},
    {"global_settings", "assumed_gamma", 0.1},
    {"global_settings", "max_trace_level", 0},
    {"global_settings", "number_of_waves", 1},
    {"global_settings", "mm_per_unit", 10},
    {"global_settings", "adc_bailout", 0},
});

bool is_camera(std::string_view item) {
    return std::ranges::any_of(Kinds<Camera>::infos,
                               [&](const ItemInfo* camera) { return camera->name == item; });
}

/// What counts instead of a number outside of the range.
double instead(const Range& range, const RenderedRange& rule, double x) {
    if (rule.wraps > 0) {
        const double turns = std::floor((x - range.low) / rule.wraps);
        const double wrapped = x - turns * rule.wraps;
        return range.contains(wrapped) ? wrapped : rule.least;
    }
    if (rule.any_sign && range.contains(std::abs(x))) return std::abs(x);
    return x > range.high && !rule.always ? range.high : rule.least;
}

}  // namespace

const RenderedRange* rendered_range(std::string_view item, std::string_view field) {
    const auto* const found = std::ranges::find_if(rendered_ranges, [&](const RenderedRange& each) {
        const bool named = each.item == item || (each.item == "camera" && is_camera(item));
        return named && each.field == field;
    });
    return found == rendered_ranges.end() ? nullptr : found;
}

double bring_into(const Range& range, const RenderedRange& rule, FieldValue& value) {
    double last = 0;
    const auto bring = [&](double* at, int count) {
        for (int i = 0; i < count; ++i) {
            if (range.contains(at[i])) continue;
            last = at[i] = instead(range, rule, at[i]);
        }
    };
    if (auto* x = std::get_if<double>(&value)) bring(x, 1);
    if (auto* v = std::get_if<Vec2>(&value)) bring(&v->x, 2);
    if (auto* v = std::get_if<Vec3>(&value)) bring(&v->x, 3);
    return last;
}

}  // namespace candelabra
