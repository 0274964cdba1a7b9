// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/random.h"

std::uint64_t mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

double uniform(const Key& key, Purpose purpose) {
    std::uint64_t h = mix(key.pixel);
    h = mix(h ^ (std::uint64_t{key.sample} << 32 | key.path));
    h = mix(h ^ (std::uint64_t{key.branch} << 32 | static_cast<std::uint32_t>(purpose)));
    return static_cast<double>(h >> 11) * 0x1p-53;
}
