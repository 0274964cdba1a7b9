// SPDX-License-Identifier: GPL-3.0-or-later
// A ball around all lights of a scene, for directions towards them.
#pragma once

#include "base/box.h"
#include "lighting/choosable_lights.h"
#include "lighting/light_tree.h"

#include <cmath>

namespace candelabra {

struct LightBall {
    Vec3 centre = Vec3(0);
    double radius = 0;
};

/// Centred on the box, and as tight as spheres around the lights in it allow. Those that fall off
/// otherwise than with the square of the distance have no surface, and do not count.
inline LightBall ball_around(const Box& box, const ChoosableLights& lights) {
    LightBall ball{box.centre(), 0};
    for (const LightCopy& copy : lights.copies()) {
        const Box own = copy.lights->box(copy.lights->root());
        ball.radius = std::fmax(ball.radius, length(copy.place->point(own.centre()) - ball.centre) +
                                                 copy.scale * 0.5 * length(own.size()));
    }
    for_single_lights(lights, [&](LightIndex light) {
        if (lights.falls_off() && lights.falloff(light)) return;
        const LightBounds b = lights.bounds(light);
        ball.radius = std::fmax(ball.radius, length(b.centre - ball.centre) + b.radius);
    });
    return ball;
}

}  // namespace candelabra
