// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/laws.h"

namespace candelabra::proof {

Claims superposition(const Script& script, Dice&) {
    if (script.lights < 2) return {};
    std::vector<Term> sum;
    for (int light = 0; light < script.lights; ++light)
        sum.push_back(picture(script, {.only = light}).front());
    return {same_mean("all lights = the sum of each", picture(script), sum)};
}

}  // namespace candelabra::proof
