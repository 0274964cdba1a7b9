// SPDX-License-Identifier: GPL-3.0-or-later
// POV-Ray 3.7's noise: smooth random numbers and vectors over space, their sums over octaves, and
// the hash and random table of the cellular patterns. Used by the patterns, the internal functions
// and vturbulence(). Pure; the tables are the same on every machine.
#pragma once

#include "base/vector.h"

#include <cstdint>
#include <span>

namespace candelabra {

/// Generator of the scalar noise. 1 and 2 differ in range, 3 is Perlin's gradient noise.
enum class NoiseGenerator : std::uint8_t { original = 1, full_range = 2, perlin = 3 };

/// Converts a number in the language to a generator: its two lowest bits, where 0 counts as 1.
NoiseGenerator noise_generator(double number);

/// Returns a value from 0 to 1, both included. Points that are not finite count as the origin.
double noise(const Vec3& point, NoiseGenerator);

/// The same at the point times each frequency; faster than separate calls.
void noises(const Vec3& point, std::span<const double> frequencies, NoiseGenerator, double* values);

/// Three independent noises, from about -1 to 1; the same for all generators.
Vec3 vector_noise(const Vec3& point);

/// A sum of noises, each at `lambda` times the frequency of the one before and `omega` times its
/// weight.
struct Octaves {
    static constexpr int most = 10;

    int count = 6;      ///< used as 1 to `most`
    float omega = 0.5;  ///< omega and lambda are in single precision, as in POV-Ray
    float lambda = 2;
    friend bool operator==(const Octaves&, const Octaves&) = default;
};

Vec3 turbulence(const Vec3& point, const Octaves&);
double scalar_turbulence(const Vec3& point, const Octaves&, NoiseGenerator);

/// Returns 0 to 4095 for a cell of the integer lattice; coordinates are taken modulo 4096.
std::uint32_t cell_hash(std::int64_t x, std::int64_t y, std::int64_t z);

/// Random numbers in [0, 1), in a fixed order; their number is a power of two.
std::span<const double> random_table();

/// POV-Ray's linear congruential generator, 15 bits at a time.
class NoiseSequence {
public:
    constexpr explicit NoiseSequence(std::uint32_t state) : state_(state) {}
    constexpr std::uint32_t next() {
        state_ = state_ * 1812433253u + 12345u;
        return state_ >> 16 & 0x7fff;
    }

private:
    std::uint32_t state_;
};

}  // namespace candelabra
