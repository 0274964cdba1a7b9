// SPDX-License-Identifier: GPL-3.0-or-later
// A scene for tests of the renderer, and sizes of its pictures.
#pragma once

#include "render/render.h"
#include "support/scripts.h"

namespace candelabra {

inline const char* const four_lamps = R"(
    #version 3.7;
    camera { location <0, 3, -8> look_at <0, 1, 0> right x up y angle 50 }
    plane { y, 0 pigment { checker rgb 0.9, rgb 0.4 } finish { ambient 0 diffuse 0.8 } }
    sphere { <0, 1, 0>, 1 pigment { rgb 0.6 } finish { ambient 0 diffuse 0.7 reflection 0.2 } }
    #for (I, 0, 11)
        sphere { <2, 0.4, 0>, 0.2 rotate 30*I*y pigment { rgb <1, 0.8, 0.5> } finish { diffuse 0 emission 6 } }
    #end
)";

inline RenderSettings small(int threads) {
    RenderSettings settings;
    settings.width = 45;
    settings.height = 37;
    settings.threads = threads;
    return settings;
}

inline RenderSettings of_samples(int samples) {
    RenderSettings settings;
    settings.width = settings.height = 32;
    settings.samples = samples;
    return settings;
}

}  // namespace candelabra
