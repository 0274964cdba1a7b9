// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers for strategies that need more than one for the same purpose.
#pragma once

#include "base/random.h"
#include "base/vector.h"

namespace candelabra {

/// A place on a luminaire, or a direction, as chosen by the key: uniform in [0, 1)^2.
inline Vec2 place_on_light(const Key& key) {
    return {uniform(key, Purpose::light_u), uniform(key, Purpose::light_v)};
}

/// Random number n for a purpose; independent of the others and of uniform(key, purpose).
inline double draw(const Key& key, Purpose purpose, std::uint64_t n) {
    Key other = key;
    other.pixel = mix(key.pixel ^ mix(n));
    return uniform(other, purpose);
}

/// The same as an integer in [0, count). Precondition: 0 < count <= 2^53.
inline std::uint64_t draw_integer(const Key& key, Purpose purpose, std::uint64_t n,
                                  std::uint64_t count) {
    const auto result =
        static_cast<std::uint64_t>(draw(key, purpose, n) * static_cast<double>(count));
    return result < count ? result : count - 1;
}

}  // namespace candelabra
