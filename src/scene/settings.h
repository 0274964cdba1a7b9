// SPDX-License-Identifier: GPL-3.0-or-later
// Settings of the scene (global_settings) and of the run (command line).
#pragma once

#include "base/rgb.h"
#include "camera/film_settings.h"
#include "index/settings.h"
#include "lighting/settings.h"
#include "method/photons.h"
#include "method/radiosity.h"
#include "method/settings.h"
#include "photometry/light_units.h"
#include "surface/subsurface.h"
#include "vocabulary/item_info.h"

#include <cstdint>
#include <optional>

namespace candelabra {

/// Settings in the scene. Defaults are POV-Ray 3.7's.
struct GlobalSettings {
    Rgb ambient_light = Rgb(1);
    double assumed_gamma = 1;
    int max_trace_level = 5;
    int noise_generator = 2;
    int number_of_waves = 10;
    Rgb irid_wavelength = Rgb(0.7, 0.52, 0.48);
    double adc_bailout = 1.0 / 255;
    bool ambient_luminaires = false;  ///< objects with ambient of 1 or more are luminaires
    /// Objects with a greater radiance at some point in some channel are luminaires. Infinite: none
    /// are.
    double luminaires_above = 0;
    bool luminaires_said = false;   ///< the scene defines luminaires
    double mm_per_unit = 10;        ///< millimetres per scene unit, for translucency
    PhotometricUnits photometry;    ///< from the block of that name
    SubsurfaceSettings subsurface;  ///< from the block of that name
    Radiosity radiosity;            ///< the same
    PhotonSettings photons;         ///< the same
    /// From the block of that name, which the evaluator reads.
    LightSampler light_sampler = LightOctree{};
    RayIndex index;                 ///< the same
    IntegratorSettings integrator;  ///< the same

    static const ItemInfo vocabulary;

    /// What its numbers are in metres and in candela.
    LightUnits light_units() const {
        return {photometry.unit.value_or(mm_per_unit / 1000), photometry.white};
    }
};

/// Settings of the run: size, quality and effort. Set by the command line; help and manual are made
/// from them.
struct RenderSettings {
    int width = 640;
    int height = 480;
    bool antialias = true;    ///< false: all camera rays go through the middle of the pixel
    int sampling_method = 1;  ///< of antialiasing; see the vocabulary
    double antialias_threshold = 0.3;  ///< see the vocabulary
    int antialias_depth = 3;
    double antialias_gamma = 2.5;  ///< gamma of the values that the threshold compares
    bool jitter = true;            ///< false: the rays of a pixel form a grid
    double jitter_amount = 1;
    int samples = 0;      ///< camera rays for each pixel; 0: as many as each needs
    double noise = 0;     ///< standard error at which to stop, see the vocabulary; 0: none
    int shadow_rays = 0;  ///< choices of luminaires at each hit; 0: as many as pay off
    int quality = 9;      ///< POV-Ray's: see surface/quality.h
    bool ambient_luminaires = false;  ///< as the global setting of that name
    int seed = 0;
    int threads = 0;                               ///< 0: one per core
    std::optional<LightSampler> light_sampler;     ///< overrides the scene's
    std::optional<RayIndex> index;                 ///< the same
    std::optional<IntegratorSettings> integrator;  ///< the same
    std::optional<double> luminaires_above;        ///< the same
    std::vector<FilmChange> film;                  ///< changes to the camera's film

    static const ItemInfo vocabulary;
};

/// Overrides the scene's rule for luminaires and its integrator by those of the run, if given.
void settle_settings(GlobalSettings&, const RenderSettings&);

/// Applies the run's changes to the film. Returns an error as a sentence, or an empty string.
std::string settle_film(FilmSettings&, const RenderSettings&);

}  // namespace candelabra
