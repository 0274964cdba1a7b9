// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of four by three pixels with an edge in it, for tests of antialiasing.
#pragma once

#include "render/render.h"
#include "support/scripts.h"
#include "text/message.h"

#include <string>

namespace candelabra {

inline RenderSettings rows(int depth) {
    RenderSettings settings;
    settings.width = 4;
    settings.height = 3;
    settings.antialias_depth = depth;
    settings.jitter = false;
    return settings;
}

/// Two colours with an edge between them, so many pixels from the left.
inline std::string edge(double place, double left, double right) {
    return message(R"(
        #version 3.7;
        global_settings { assumed_gamma 1 }
        camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 direction z }
        plane { z, 0
            pigment { gradient x color_map { [.5 rgb )",
                   left, "][.5 rgb ", right, R"(] } scale 40 translate <)", place - 22, R"(, 0, 0> }
            finish { ambient 1 diffuse 0 } })");
}

}  // namespace candelabra
