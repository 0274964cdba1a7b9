// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/laws.h"

namespace candelabra::proof {

Claims more_light(const Script& script, Dice& dice) {
    const double factor = dice.pick<double>({1e6, 1000, 3, 1e-3, 1e-6});
    return {same_mean("light times " + text_of(factor), picture(script),
                      picture(script, {.light = factor}, 1 / factor))};
}

Claims motion(const Script& script, Dice& dice) {
    const std::string way = dice.pick<std::string>(
        {"translate <1000, -300, 200>", "rotate <30, 70, -20>", "scale <-1, 1, 1>",
         "scale <1, 1, -1> rotate 90*y", "matrix <0, 1, 0, 0, 0, 1, 1, 0, 0, 5, -3, 2>"});
    return {same_mean(way, picture(script), picture(transformed(script, way)))};
}

Claims other_size(const Script& script, Dice& dice) {
    const double factor = dice.pick<double>({2, 1024, 1.0 / 128, 1e3, 1e6, 0.1});
    const std::string way = "scale " + text_of(factor);
    return {same_mean(way, picture(script), picture(transformed(script, way)))};
}

}  // namespace candelabra::proof
