// SPDX-License-Identifier: GPL-3.0-or-later
// What a rendering cost, in rays.
#pragma once

#include <cstdint>

struct RayCounts {
    std::uint64_t camera = 0;
    std::uint64_t shadow = 0;     ///< towards luminaires and light sources
    std::uint64_t scattered = 0;  ///< reflected and refracted

    RayCounts& operator+=(const RayCounts& other) {
        camera += other.camera;
        shadow += other.shadow;
        scattered += other.scattered;
        return *this;
    }
};
