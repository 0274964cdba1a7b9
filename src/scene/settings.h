// SPDX-License-Identifier: GPL-3.0-or-later
// Settings of the scene (global_settings) and of the run (command line).
#pragma once

#include "lighting/settings.h"
#include "vocabulary/schema.h"

#include <cstdint>
#include <optional>

/// What the scene says about itself. Defaults are POV-Ray 3.7's.
struct GlobalSettings {
    Vec3 ambient_light = Vec3(1);
    double assumed_gamma = 1;
    int max_trace_level = 5;
    double adc_bailout = 1.0 / 255;
    LightSampler light_sampler =
        LightOctree{};  ///< from the block of that name, which the evaluator reads

    static consteval auto vocabulary();
};

consteval auto GlobalSettings::vocabulary() {
    using F = Field<GlobalSettings>;
    return schema<GlobalSettings>(
        "global_settings", "What holds for the whole scene.",
        as_colour(F{"ambient_light", &GlobalSettings::ambient_light, item,
                    "light that seems to come from everywhere"}),
        F{"assumed_gamma", &GlobalSettings::assumed_gamma, item,
          "power by which the scene's colours become linear light; 1: they are", above(0)},
        F{"max_trace_level", &GlobalSettings::max_trace_level, item,
          "how many reflections and refractions are followed", between(1, 256)},
        F{"adc_bailout", &GlobalSettings::adc_bailout, item,
          "rays that can change the pixel by less than this are dropped", at_least(0)});
}

/// What the run says: how large, how fine, with how much work. Set by the command line; help and
/// manual read it from here.
struct RenderSettings {
    int width = 640;
    int height = 480;
    bool antialias = true;  ///< false: all camera rays go through the middle of the pixel
    double antialias_threshold = 0.3;  ///< see the vocabulary
    int antialias_depth = 3;
    int samples = 0;      ///< camera rays for each pixel; 0: as many as each needs
    int shadow_rays = 1;  ///< choices of luminaires at each hit
    int seed = 0;
    int threads = 0;                            ///< 0: one per core
    std::optional<LightSampler> light_sampler;  ///< overrides the scene's

    static consteval auto vocabulary();
};

consteval auto RenderSettings::vocabulary() {
    using F = Field<RenderSettings>;
    return schema<RenderSettings>(
        "render_settings", "What holds for the run.",
        F{"width", &RenderSettings::width, item, "width of the picture in pixels",
          between(1, 65535)},
        F{"height", &RenderSettings::height, item, "height of the picture in pixels",
          between(1, 65535)},
        F{"antialias", &RenderSettings::antialias, flag,
          "spread the camera rays over the pixel; off: all go through its middle"},
        F{"antialias_threshold", &RenderSettings::antialias_threshold, item,
          "a pixel gets more rays while the standard error of its displayed colour, summed over "
          "red, green and blue (each 0 to 1), is above a tenth of this",
          at_least(0)},
        F{"antialias_depth", &RenderSettings::antialias_depth, item,
          "when the number of rays is chosen for each pixel, it is at most 4 to this power",
          between(1, 9)},
        F{"samples", &RenderSettings::samples, item,
          "camera rays for each pixel; 0: as many as each needs", between(0, 1e6)},
        F{"shadow_rays", &RenderSettings::shadow_rays, item,
          "how often luminaires are chosen at each hit", between(1, 1e4)},
        F{"seed", &RenderSettings::seed, item, "another seed gives other noise",
          between(0, std::numeric_limits<int>::max())},
        F{"threads", &RenderSettings::threads, item, "threads that work; 0: one for each core",
          between(0, 4096)});
}
