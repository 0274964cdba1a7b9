// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/settings.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo GlobalSettings::vocabulary = described<GlobalSettings>([] {
    using F = Field<GlobalSettings>;
    return schema<GlobalSettings>(
        "global_settings", "What holds for the whole scene.",
        as_colour(F{"ambient_light", &GlobalSettings::ambient_light, item,
                    "light that seems to come from everywhere"}),
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
        as_colour(F{"irid_wavelength", &GlobalSettings::irid_wavelength, item,
                    "wavelengths of red, green and blue light for iridescence"}),
        F{"mm_per_unit", &GlobalSettings::mm_per_unit, item,
          "how many millimetres a unit of the scene is: translucency is measured in them",
          above(0)},
        F{"adc_bailout", &GlobalSettings::adc_bailout, item,
          "rays that can change the pixel by less than this are dropped", at_least(0)});
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
          "more camera rays, spread over the pixel, where the threshold asks for them; off: all go "
          "through its middle"},
        F{"antialias_threshold", &RenderSettings::antialias_threshold, item,
          "a pixel that differs from one beside it by so much, summed over red, green and blue "
          "(each 0 to 1), gets more rays, and so does the other; where light is left to chance, it "
          "gets them while the standard error of its colour is above a tenth of this",
          at_least(0)},
        F{"sampling_method", &RenderSettings::sampling_method, item,
          "1: one ray through the middle of each pixel, more where pixels differ; 2 and 3: rays "
          "through its corners, and those of its quarters where corners differ; where light is "
          "left to chance, the number changes nothing",
          between(1, 3)},
        F{"antialias_depth", &RenderSettings::antialias_depth, item,
          "a pixel gets so many rays more across and down, or by method 2 is quartered one time "
          "less than this; where light is left to chance, it gets at most 4 to this power "
          "altogether",
          between(1, 9)},
        F{"antialias_gamma", &RenderSettings::antialias_gamma, item,
          "the threshold is for differences of linear values to the power of 1 over this",
          above(0)},
        F{"jitter", &RenderSettings::jitter, flag,
          "moves the additional rays of a pixel at random; off: they form a grid"},
        F{"jitter_amount", &RenderSettings::jitter_amount, item,
          "how far additional rays of a pixel move at random, in parts of the distance between two "
          "of the grid",
          at_least(0)},
        F{"samples", &RenderSettings::samples, item,
          "camera rays for each pixel; 0: as many as each needs", between(0, 1e6)},
        F{"noise", &RenderSettings::noise, item,
          "all pixels get rays until the standard error of their displayed colours (each channel 0 "
          "to 1, summed over the three) is below this, or there are as many as samples says; 0: "
          "no such bound",
          between(0, 3)},
        F{"shadow_rays", &RenderSettings::shadow_rays, item,
          "how often luminaires are chosen at each hit; 0: as often as pays", between(0, 1e4)},
        F{"quality", &RenderSettings::quality, item,
          "how much is shown: 0 colours, 2 light, 4 shadows, 5 area lights, 6 pigments and what is "
          "behind, 8 reflections and normals, 9 everything",
          between(0, 11)},
        F{"ambient_luminaires", &RenderSettings::ambient_luminaires, flag,
          "objects whose ambient is 1 or more are luminaires, as with luminaires ambient in the "
          "scene's global_settings"},
        F{"seed", &RenderSettings::seed, item, "another seed gives other noise",
          between(0, std::numeric_limits<int>::max())},
        F{"threads", &RenderSettings::threads, item, "threads that work; 0: one for each core",
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
