// SPDX-License-Identifier: GPL-3.0-or-later
#include "method/settings.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo PovRay::vocabulary = described<PovRay>([] {
    return schema<PovRay>("pov_ray",
                          {"Reflections and refractions, and light that comes straight from lights "
                           "and luminaires, as POV-Ray.",
                           "global_settings { integrator { pov_ray } }"});
});

const ItemInfo PathTraced::vocabulary = described<PathTraced>([] {
    using F = Field<PathTraced>;
    return schema<PathTraced>(
        "path_traced",
        {"Path tracing: reflected light lights other surfaces, too. In scenes of `#version 3.7` "
         "and "
         "later, it replaces `ambient`.",
         "global_settings { integrator { path_traced } }",
         "global_settings { integrator { path_traced bounces 6 } }",
         "global_settings { integrator { path_traced bounces 6 reflected_luminaires 1000 } }"},
        F{"bounces", &PathTraced::bounces, item,
          "diffuse reflections on the way of light to a surface that is seen", between(0, 1000)},
        F{"reflected_luminaires", &PathTraced::reflected_luminaires, item,
          "number of light paths, for each four samples of a pixel, whose reflections become "
          "luminaires; 0: none; left out: a sixteenth of the pixels, 500 to 5000, unless a trial "
          "of some pixels finds that paths from the camera alone make less noise for their time",
          between(0, 10000000)});
});

}  // namespace candelabra
