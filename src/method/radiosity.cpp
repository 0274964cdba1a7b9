// SPDX-License-Identifier: GPL-3.0-or-later
#include "method/radiosity.h"

#include "base/colour.h"
#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo Radiosity::vocabulary = described<Radiosity>([] {
    using F = Field<Radiosity>;
    constexpr const char* of_cache = "of POV-Ray's cache; no effect, as there is none";
    return schema<Radiosity>(
        "radiosity",
        {"Light that surfaces reflect lights others, too. Every camera ray follows some of it, so "
         "that the picture is exact on average; more samples make it quieter.",
         "global_settings { radiosity { count 50 recursion_limit 2 error_bound 0.5 } }",
         "global_settings { radiosity { count 50 normal on media on always_sample off brightness 1 "
         "gray_threshold 0 } }",
         "global_settings { radiosity { nearest_count 5 low_error_factor 0.5 minimum_reuse 0.015 "
         "maximum_reuse 0.2 max_sample 2 adc_bailout 0.01 pretrace_start 0.08 pretrace_end 0.01 "
         "subsurface on } }"},
        F{"recursion_limit", &Radiosity::recursion_limit, item,
          "diffuse reflections on the way of light to a surface that is seen", between(1, 20)},
        F{"brightness", &Radiosity::brightness, item, "factor of the light at each of them",
          above(0)},
        F{"gray_threshold", &Radiosity::gray_threshold, item,
          "share of the light that loses its colour at each of them", between(0, 1)},
        F{"max_sample", &Radiosity::max_sample, item,
          "greatest channel of the light from one direction; 0 or less: no bound"},
        F{"normal", &Radiosity::normal, flag, "light is gathered about the disturbed normal"},
        F{"media", &Radiosity::media, flag, "fog is there for reflected light as well"},
        F{"count", &Radiosity::count, item, of_cache, at_least(1)},
        maybe(F{"directions", &Radiosity::directions, following, of_cache, at_least(1)}),
        F{"error_bound", &Radiosity::error_bound, item, of_cache, above(0)},
        F{"nearest_count", &Radiosity::nearest_count, item, of_cache, between(1, 20)},
        maybe(F{"nearest_at_least", &Radiosity::nearest_at_least, following, of_cache,
                between(0, 20)}),
        F{"low_error_factor", &Radiosity::low_error_factor, item, of_cache, above(0)},
        F{"minimum_reuse", &Radiosity::minimum_reuse, item, of_cache, at_least(0)},
        F{"maximum_reuse", &Radiosity::maximum_reuse, item, of_cache, at_least(0)},
        F{"pretrace_start", &Radiosity::pretrace_start, item, of_cache, between(0, 1)},
        F{"pretrace_end", &Radiosity::pretrace_end, item, of_cache, between(0, 1)},
        F{"adc_bailout", &Radiosity::adc_bailout, item, of_cache, at_least(0)},
        F{"always_sample", &Radiosity::always_sample, flag, of_cache},
        F{"subsurface", &Radiosity::subsurface, flag, of_cache},
        F{"save_file", &Radiosity::save_file, item, of_cache},
        F{"load_file", &Radiosity::load_file, item, of_cache});
});

Rgb gathered_light(const Radiosity& r, const Rgb& radiance) {
    Rgb light = radiance;
    const double brightest = max_component(light);
    if (r.max_sample > 0 && brightest > r.max_sample) light *= r.max_sample / brightest;
    return reflected_light(r, light);
}

Rgb reflected_light(const Radiosity& r, const Rgb& light) {
    return r.brightness * mix(light, Rgb(grey(light)), r.gray_threshold);
}

}  // namespace candelabra
