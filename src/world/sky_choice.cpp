// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/sky_choice.h"

#include "base/colour.h"

#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

/// Number of directions in each dimension of draw() in which the brightest light is sought.
constexpr int tries = 64;

}  // namespace

SkyChoice::SkyChoice(const World& world) : world_(world) {
    for (int i = 0; i < tries; ++i)
        for (int j = 0; j < tries; ++j) {
            const auto [direction, density] =
                world.sky.light.draw({(i + 0.5) / tries, (j + 0.5) / tries});
            const double seen = luminance(direction);
            brightest_ = std::fmax(brightest_, seen);
            mean_ += seen / (4 * std::numbers::pi * density * tries * tries);
        }
}

double SkyChoice::luminance(const Vec3& direction) const {
    return std::fmax(candelabra::luminance(world_.sky_radiance(direction)), 0);
}

}  // namespace candelabra
