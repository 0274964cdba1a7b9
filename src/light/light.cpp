// SPDX-License-Identifier: GPL-3.0-or-later
#include "light/light.h"

double fading(const PointLight& light, double distance) {
    if (light.fade_power <= 0 || light.fade_distance <= 0) return 1;
    return 2 / (1 + std::pow(distance / light.fade_distance, light.fade_power));
}
