// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/laws.h"

namespace candelabra::proof {

/// A source of colour c with fade_distance d far below its distance r and fade_power 2 gives
/// 2 c (d / r)^2, and a ball of radius b and radiance e gives e (b / r)^2, as POV-Ray counts light.
Claims point_or_ball(const Script& script, Dice& dice) {
    const std::string place = dice.pick<std::string>(
        {"<1.5, 2.5, -2>", "<-1.5, 1.2, -1.5>", "<0.2, 3, 0.3>", "<-2.5, 0.8, 1>"});
    Script source = script, ball = script;
    source.elements.push_back(block(
        "light_source", place + ", rgb 2e6 fade_distance 1e-3 fade_power 2 media_attenuation on"));
    ball.elements.push_back(
        block("sphere", place + ", 0.01 pigment { rgb 1 } finish { diffuse 0 emission 40000 } "
                                "no_image no_reflection"));
    return {same_mean("point = ball", picture(source), picture(ball), 5e-3)};
}

}  // namespace candelabra::proof
