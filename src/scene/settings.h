// SPDX-License-Identifier: GPL-3.0-or-later
// Settings of the scene (global_settings) and of the run (command line).
#pragma once

#include "camera/film_settings.h"
#include "index/settings.h"
#include "lighting/settings.h"
#include "method/photons.h"
#include "method/radiosity.h"
#include "method/settings.h"
#include "surface/subsurface.h"
#include "vocabulary/item_info.h"

#include <cstdint>
#include <optional>

namespace candelabra {

/// What the scene says about itself. Defaults are POV-Ray 3.7's.
struct GlobalSettings {
    Vec3 ambient_light = Vec3(1);
    double assumed_gamma = 1;
    int max_trace_level = 5;
    int noise_generator = 2;
    int number_of_waves = 10;
    Vec3 irid_wavelength = Vec3(0.7, 0.52, 0.48);
    double adc_bailout = 1.0 / 255;
    bool ambient_luminaires = false;  ///< objects with ambient of 1 or more are luminaires
    /// Luminaires have a greater radiance somewhere, in some channel. Infinite: nothing is one.
    double luminaires_above = 0;
    bool luminaires_said = false;   ///< the scene says what is one
    double mm_per_unit = 10;        ///< millimetres; for translucency
    SubsurfaceSettings subsurface;  ///< from the block of that name
    Radiosity radiosity;            ///< the same
    PhotonSettings photons;         ///< the same
    /// From the block of that name, which the evaluator reads.
    LightSampler light_sampler = LightOctree{};
    RayIndex index;                 ///< the same
    IntegratorSettings integrator;  ///< the same

    static const ItemInfo vocabulary;
};

/// What the run says: how large, how fine, with how much work. Set by the command line; help and
/// manual read it from here.
struct RenderSettings {
    int width = 640;
    int height = 480;
    bool antialias = true;    ///< false: all camera rays go through the middle of the pixel
    int sampling_method = 1;  ///< of antialiasing; see the vocabulary
    double antialias_threshold = 0.3;  ///< see the vocabulary
    int antialias_depth = 3;
    double antialias_gamma = 2.5;  ///< of the values whose differences the threshold is for
    bool jitter = true;            ///< false: rays of one pixel are in rows
    double jitter_amount = 1;
    int samples = 0;      ///< camera rays for each pixel; 0: as many as each needs
    double noise = 0;     ///< standard error that ends the work, see the vocabulary; 0: no such end
    int shadow_rays = 1;  ///< choices of luminaires at each hit; 0: as many as pay
    int quality = 9;      ///< POV-Ray's: see surface/quality.h
    bool ambient_luminaires = false;  ///< as the global setting of that name
    int seed = 0;
    int threads = 0;                               ///< 0: one per core
    std::optional<LightSampler> light_sampler;     ///< overrides the scene's
    std::optional<RayIndex> index;                 ///< the same
    std::optional<IntegratorSettings> integrator;  ///< the same
    std::optional<double> luminaires_above;        ///< the same
    std::vector<FilmChange> film;                  ///< changes of the camera's

    static const ItemInfo vocabulary;
};

/// Gives the scene what the run says instead: its rule of what is a luminaire, and its integrator.
void settle_settings(GlobalSettings&, const RenderSettings&);

/// The film with the run's changes; an error as a sentence, empty when there is none.
std::string settle_film(FilmSettings&, const RenderSettings&);

}  // namespace candelabra
