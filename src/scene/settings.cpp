// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/settings.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo GlobalSettings::vocabulary = described<GlobalSettings>([] {
    using F = Field<GlobalSettings>;
    return schema<GlobalSettings>(
        "global_settings",
        {"What holds for the whole scene.", "global_settings { assumed_gamma 1 }",
         "global_settings { max_trace_level 10 adc_bailout 1/255 ambient_light rgb 0.5 }",
         "global_settings { noise_generator 2 number_of_waves 10 irid_wavelength rgb <0.25, 0.18, "
         "0.14> mm_per_unit 100 }"},
        F{"ambient_light", &GlobalSettings::ambient_light, item,
          "light that seems to come from everywhere"},
        F{"assumed_gamma", &GlobalSettings::assumed_gamma, item,
          "power by which the scene's colours become linear light; 1: they are", between(0.1, 10)},
        F{"max_trace_level", &GlobalSettings::max_trace_level, item,
          "how many reflections and refractions are followed; 0 is as 1", between(0, 256)},
        F{"noise_generator", &GlobalSettings::noise_generator, item,
          "noise of patterns that choose none: 1 and 2 differ in range, 3 is Perlin's; before "
          "language version 3.5 the default is 1",
          between(1, 3)},
        F{"number_of_waves", &GlobalSettings::number_of_waves, item,
          "how many points ripples and waves run out from", between(1, 1000)},
        F{"irid_wavelength", &GlobalSettings::irid_wavelength, item,
          "wavelengths of red, green and blue light for iridescence"},
        F{"mm_per_unit", &GlobalSettings::mm_per_unit, item,
          "how many millimetres a unit of the scene is: translucency is measured in them",
          above(0)},
        F{"adc_bailout", &GlobalSettings::adc_bailout, item,
          "smallest change of a pixel for which a ray is followed", at_least(0)});
});

const ItemInfo RenderSettings::vocabulary = described<RenderSettings>([] {
    using F = Field<RenderSettings>;
    return schema<RenderSettings>(
        "render_settings", "What holds for the run.",
        F{"width", &RenderSettings::width, item, "width of the picture in pixels",
          between(1, 65535)},
        F{"height", &RenderSettings::height, item, "height of the picture in pixels",
          between(1, 65535)},
        F{"antialias", &RenderSettings::antialias, flag,
          "antialiasing: more camera rays where neighbouring pixels differ; off: all rays pass "
          "through the middle of the pixel"},
        F{"antialias_threshold", &RenderSettings::antialias_threshold, item,
          "difference between neighbouring pixels, summed over red, green and blue (each 0 to 1), "
          "above which both get more rays; in scenes with random light, a pixel gets more rays "
          "until the standard error of its colour is below a tenth of the threshold",
          at_least(0)},
        F{"sampling_method", &RenderSettings::sampling_method, item,
          "antialiasing method; 1: one ray through the middle of each pixel, more where pixels "
          "differ; 2 and 3: rays through the corners of each pixel, and of its quarters where "
          "corners differ; without effect in scenes with random light",
          between(1, 3)},
        F{"antialias_depth", &RenderSettings::antialias_depth, item,
          "limit of antialiasing; with method 1, a pixel gets at most this number of rays in each "
          "direction in addition; with methods 2 and 3, it is divided one time less than this "
          "number; in scenes with random light, 4 to the power of this number is the most rays for "
          "a pixel",
          between(1, 9)},
        F{"antialias_gamma", &RenderSettings::antialias_gamma, item,
          "gamma of the values that the antialiasing threshold compares", above(0)},
        F{"jitter", &RenderSettings::jitter, flag,
          "moves additional antialiasing rays at random; off: a regular grid"},
        F{"jitter_amount", &RenderSettings::jitter_amount, item,
          "largest random shift of an additional antialiasing ray, as a fraction of the grid's "
          "spacing",
          at_least(0)},
        F{"samples", &RenderSettings::samples, item,
          "camera rays per pixel; 0: as many as each pixel needs", between(0, 1e6)},
        F{"noise", &RenderSettings::noise, item,
          "target noise: rendering goes on until the standard error of each pixel's displayed "
          "colour (the sum over three channels of 0 to 1) is below this number, or --samples is "
          "reached; 0: no target",
          between(0, 3)},
        F{"shadow_rays", &RenderSettings::shadow_rays, item,
          "luminaires sampled at each hit; 0: the number that gives the least noise for the time",
          between(0, 1e4)},
        F{"quality", &RenderSettings::quality, item,
          "level of detail: 0 plain colours, 2 light, 4 shadows, 5 area lights, 6 pigments and "
          "transparency, 8 reflections and normals, 9 everything",
          between(0, 11)},
        F{"ambient_luminaires", &RenderSettings::ambient_luminaires, flag,
          "objects with an ambient of 1 or more light their surroundings, like luminaires ambient "
          "in global_settings"},
        F{"seed", &RenderSettings::seed, item,
          "seed of all random numbers; each seed gives a different noise pattern",
          between(0, std::numeric_limits<int>::max())},
        F{"threads", &RenderSettings::threads, item, "number of threads; 0: one per core",
          between(0, 4096)});
});

void settle_settings(GlobalSettings& scene, const RenderSettings& run) {
    scene.ambient_luminaires |= run.ambient_luminaires;
    if (run.integrator) scene.integrator = *run.integrator;
    if (!run.luminaires_above) return;
    scene.luminaires_above = *run.luminaires_above;
    scene.luminaires_said = true;
}

std::string settle_film(FilmSettings& film, const RenderSettings& run) {
    for (const FilmChange& each : run.film)
        if (std::string wrong = change(film, each); !wrong.empty()) return wrong;
    return {};
}

}  // namespace candelabra
