// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/random.h"

namespace candelabra {

namespace {

std::uint32_t reversed(std::uint32_t x) {
    x = (x & 0x55555555u) << 1 | (x >> 1 & 0x55555555u);
    x = (x & 0x33333333u) << 2 | (x >> 2 & 0x33333333u);
    x = (x & 0x0f0f0f0fu) << 4 | (x >> 4 & 0x0f0f0f0fu);
    return __builtin_bswap32(x);
}

/// Owen's scrambling of a number with reversed bits: each bit is flipped according to a hash of the
/// more significant ones (Laine and Karras, "Stratified Sampling for Stochastic Transparency",
/// 2011, with the constants of Vegdahl).
std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

/// The second dimension of Sobol's sequence, with reversed bits: the product with Pascal's triangle
/// modulo 2, in five similar steps.
std::uint32_t pascal(std::uint32_t x) {
    x ^= x >> 1 & 0x55555555u;
    x ^= x >> 2 & 0x33333333u;
    x ^= x >> 4 & 0x0f0f0f0fu;
    x ^= x >> 8 & 0x00ff00ffu;
    x ^= x >> 16 & 0x0000ffffu;
    return x;
}

/// Pairs of purposes form points in the plane; the others are one-dimensional.
struct Dimension {
    std::uint32_t pair;
    bool second;
};
Dimension dimension(Purpose purpose) {
    switch (purpose) {
        case Purpose::pixel_y:
            return {static_cast<std::uint32_t>(Purpose::pixel_x), true};
        case Purpose::light_v:
            return {static_cast<std::uint32_t>(Purpose::light_u), true};
        case Purpose::lens_v:
            return {static_cast<std::uint32_t>(Purpose::lens_u), true};
        case Purpose::sky_v:
            return {static_cast<std::uint32_t>(Purpose::sky_u), true};
        case Purpose::facet_v:
            return {static_cast<std::uint32_t>(Purpose::facet_u), true};
        case Purpose::bounce_v:
            return {static_cast<std::uint32_t>(Purpose::bounce_u), true};
        case Purpose::meter_v:
            return {static_cast<std::uint32_t>(Purpose::meter_u), true};
        case Purpose::media_direction_v:
            return {static_cast<std::uint32_t>(Purpose::media_direction_u), true};
        case Purpose::survey_v:
            return {static_cast<std::uint32_t>(Purpose::survey_u), true};
        case Purpose::sent_v:
            return {static_cast<std::uint32_t>(Purpose::sent_u), true};
        case Purpose::sent_grid_v:
            return {static_cast<std::uint32_t>(Purpose::sent_grid_u), true};
        case Purpose::photon_v:
            return {static_cast<std::uint32_t>(Purpose::photon_u), true};
        case Purpose::subsurface_v:
            return {static_cast<std::uint32_t>(Purpose::subsurface_u), true};
        case Purpose::glare_v:
            return {static_cast<std::uint32_t>(Purpose::glare_u), true};
        case Purpose::scatter_v:
            return {static_cast<std::uint32_t>(Purpose::scatter_u), true};
        default:
            return {static_cast<std::uint32_t>(purpose), false};
    }
}

}  // namespace

std::uint64_t mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

Key Key::branched(Branch kind, std::uint32_t number) const {
    const std::uint64_t step = std::uint64_t{static_cast<std::uint32_t>(kind)} << 32 | number;
    const std::uint64_t hash = mix(mix(step + 1) ^ path);
    return {pixel, sample, static_cast<std::uint32_t>(hash >> 32), 0};
}

double uniform(const Key& key, Purpose purpose) {
    const auto [pair, second] = dimension(purpose);
    std::uint64_t h = mix(key.pixel);
    h = mix(h ^ (std::uint64_t{key.path} << 32 | key.branch));
    h = mix(h ^ pair);
    // The order of the points is shuffled, so that unrelated pairs of dimensions stay independent
    // (Burley, "Practical Hash-based Owen Scrambling", 2020).
    const std::uint32_t index =
        reversed(scrambled(reversed(key.sample), static_cast<std::uint32_t>(h)));
    const std::uint32_t point = second ? pascal(index) : index;
    h = mix(h ^ (second ? 2 : 1));
    const std::uint32_t high = reversed(scrambled(point, static_cast<std::uint32_t>(h)));
    // The bits below 2^-32 are white noise.
    const std::uint64_t low = mix(h ^ std::uint64_t{key.sample} << 32) >> 43;
    return static_cast<double>(std::uint64_t{high} << 21 | low) * 0x1p-53;
}

RandomStream::RandomStream(const Key& key, Purpose purpose)
    : state_(
          mix(mix(mix(mix(key.pixel) ^ (std::uint64_t{key.path} << 32 | key.branch)) ^ key.sample) ^
              static_cast<std::uint64_t>(purpose))) {}

double RandomStream::next() {
    state_ += 0x9e3779b97f4a7c15u;
    return static_cast<double>(mix(state_) >> 11) * 0x1p-53;
}

}  // namespace candelabra
