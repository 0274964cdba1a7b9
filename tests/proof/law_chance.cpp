// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/laws.h"

namespace candelabra::proof {

namespace {

/// Light that is found by chance has one reflection less than light that is sampled: so many that
/// one does not count.
const std::string paths = "path_traced bounces 25 reflected_luminaires 0";

}  // namespace

Claims found_by_chance(const Script& script, Dice&) {
    const Script traced = with_setting(script, "integrator", paths);
    return {same_mean("sampled = found by chance", picture(traced),
                      picture(traced, {.found = Found::by_chance}))};
}

Claims photons_or_chance(const Script& script, Dice&) {
    const Script traced = with_setting(script, "integrator", paths);
    return {same_mean("photons = found by chance", picture(traced),
                      picture(without_setting(traced, "photons"), {.found = Found::by_chance}),
                      2e-2)};
}

Claims with_reflected_luminaires(const Script& script, Dice& dice) {
    const std::string bounces =
        "path_traced bounces " + dice.pick<std::string>({"1", "2", "4", "20"});
    return {same_mean(
        "reflected luminaires or not",
        picture(with_setting(script, "integrator", bounces + " reflected_luminaires 300")),
        picture(with_setting(script, "integrator", bounces + " reflected_luminaires 0")))};
}

}  // namespace candelabra::proof
