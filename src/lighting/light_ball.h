// SPDX-License-Identifier: GPL-3.0-or-later
// A ball around all luminaires of a scene, for directions towards them.
#pragma once

#include "base/box.h"
#include "luminaire/luminaire.h"

#include <cmath>
#include <span>

namespace candelabra {

struct LightBall {
    Vec3 centre = Vec3(0);
    double radius = 0;
};

/// Centred on the box, and as tight as spheres around the luminaires in it allow.
inline LightBall ball_around(const Box& box, std::span<const Luminaire> luminaires) {
    LightBall ball{box.centre(), 0};
    for (const Luminaire& luminaire : luminaires) {
        const LightBounds b = bounds(luminaire);
        ball.radius = std::fmax(ball.radius, length(b.centre - ball.centre) + b.radius);
    }
    return ball;
}

}  // namespace candelabra
