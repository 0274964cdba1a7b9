// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/noise.h"

#include "base/target_clones.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <random>
#include <vector>

namespace candelabra {

namespace {

constexpr std::uint32_t hash_mask = 4095;
using HashTable = std::array<std::uint16_t, hash_mask + 1>;

/// A permutation of 0 to 4095.
constexpr HashTable make_hash_table() {
    HashTable table{};
    for (std::size_t i = 0; i < table.size(); ++i) table[i] = static_cast<std::uint16_t>(i);
    NoiseSequence sequence(0);
    for (std::size_t i = table.size(); i-- > 0;)
        std::swap(table[i], table[sequence.next() & hash_mask]);
    return table;
}

/// CRC-16 of the number's bytes, high byte first, three times over.
constexpr std::uint16_t checksum(double number) {
    const auto bits = std::bit_cast<std::uint64_t>(number);
    std::uint16_t sum = 0;
    for (int byte = 0; byte < 24; ++byte) {
        sum ^= static_cast<std::uint16_t>(bits >> (56 - byte % 8 * 8) & 0xff);
        for (int bit = 0; bit < 8; ++bit)
            sum = static_cast<std::uint16_t>((sum & 1) != 0 ? sum >> 1 ^ 0xa001 : sum >> 1);
    }
    return sum;
}

/// Rounds to 6 significant decimal digits, for magnitudes from 1e-5 to 1.
constexpr double six_digits(double x) {
    double scale = 1e5;
    for (double size = x < 0 ? -x : x; size < 1; size *= 10) scale *= 10;
    const double scaled = x * scale;
    const auto whole = static_cast<std::int64_t>(scaled + (scaled < 0 ? -0.5 : 0.5));
    return static_cast<double>(whole) / scale;
}

/// Coefficients from -1 to 1. Their index is the hash (0 to 255) plus the offset of the noise (up
/// to 8) plus the number of the coefficient (up to 3).
constexpr auto make_coefficients() {
    std::array<double, 267> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double x = 2.0 * checksum(static_cast<double>(i) * 0.12345) / 65535 - 1;
        table[i] = six_digits(x);
    }
    return table;
}

/// Computed at compile time; only their address is taken at run time.
struct Tables {
    HashTable hash = make_hash_table();
    std::array<double, 267> coefficients = make_coefficients();
};
constexpr Tables tables;

/// Position of a coordinate between two neighbours on the lattice.
struct Place {
    std::array<std::uint32_t, 2> index{};
    std::array<double, 2> offset{};
    std::array<double, 2> weight{};
};

constexpr double smooth(double t) { return t * t * (3 - 2 * t); }

/// Beyond this, a double has no significant fraction.
constexpr double farthest = 1e17;

bool usable(const Vec3& p) {
    // Written so that it is false for NaN.
    return std::abs(p.x) <= farthest && std::abs(p.y) <= farthest && std::abs(p.z) <= farthest;
}

Place place_of(double t) {
    // Rounds down, but values up to 1e-10 below a negative integer count as on it.
    const auto whole = static_cast<std::int64_t>(t >= 0 ? t : t - (1 - 1e-10));
    const double fraction = t - static_cast<double>(whole);
    const auto index = static_cast<std::uint32_t>(static_cast<std::uint64_t>(whole) + 10000);
    const double far = smooth(fraction);
    return {{index & hash_mask, (index + 1) & hash_mask}, {fraction, fraction - 1}, {1 - far, far}};
}

/// Frequency factor and weight of each octave.
struct OctaveTerms {
    std::array<double, Octaves::most> frequency, weight;
    std::size_t count;

    explicit OctaveTerms(const Octaves& octaves)
        : count(static_cast<std::size_t>(std::clamp(octaves.count, 1, Octaves::most))) {
        frequency[0] = weight[0] = 1;
        for (std::size_t i = 1; i < count; ++i) {
            frequency[i] = frequency[i - 1] * octaves.lambda;
            weight[i] = weight[i - 1] * octaves.omega;
        }
    }
};

/// Vector of numbers for simultaneous arithmetic.
using Four [[gnu::vector_size(4 * sizeof(double))]] = double;

/// One or more noises at a point. At each corner of the lattice's cell a noise has four
/// coefficients; their product with (1/2, offset from the corner) is weighted by the proximity of
/// the corner.
template <std::size_t count>
[[gnu::always_inline]] inline void add_corners(const Vec3& point,
                                               std::array<double, count>& noises) {
    const Place px = place_of(point.x), py = place_of(point.y), pz = place_of(point.z);
    std::array<Four, count> sums{};
    for (std::size_t i = 0; i < 2; ++i) {
        const std::uint32_t hash_x = tables.hash[px.index[i]];
        for (std::size_t j = 0; j < 2; ++j) {
            const std::uint32_t hash_y = tables.hash[hash_x ^ py.index[j]];
            const double weight_xy = px.weight[i] * py.weight[j];
            for (std::size_t k = 0; k < 2; ++k) {
                const std::size_t hash = tables.hash[hash_y ^ pz.index[k]] & 255;
                const double* c = tables.coefficients.data() + hash;
                const double weight = weight_xy * pz.weight[k];
                const Four weighed = weight * Four{0.5, px.offset[i], py.offset[j], pz.offset[k]};
                for (std::size_t n = 0; n < count; ++n) {
                    Four own;
                    std::memcpy(&own, c + 4 * n, sizeof own);
                    sums[n] += weighed * own;
                }
            }
        }
    }
    for (std::size_t n = 0; n < count; ++n)
        noises[n] = (sums[n][0] + sums[n][2]) + (sums[n][1] + sums[n][3]);
}

CANDELABRA_TARGET_CLONES void one_noise(const Vec3& point, std::array<double, 1>& noise) {
    add_corners(point, noise);
}
CANDELABRA_TARGET_CLONES void three_noises(const Vec3& point, std::array<double, 3>& noises) {
    add_corners(point, noises);
}

double raw_noise(const Vec3& point) {
    std::array<double, 1> noise;
    one_noise(point, noise);
    return noise[0];
}

CANDELABRA_TARGET_CLONES void raw_octaves(const Vec3& point, std::span<const double> frequencies,
                                          double* noises) {
    for (const double frequency : frequencies) {
        const Vec3 p = frequency * point;
        std::array<double, 1> noise;
        add_corners(usable(p) ? p : Vec3(0), noise);
        *noises++ = noise[0];
    }
}

CANDELABRA_TARGET_CLONES void sum_octaves(const Vec3& point, const OctaveTerms& terms,
                                          std::array<double, 3>& sum) {
    for (std::size_t i = 0; i < terms.count; ++i) {
        const Vec3 p = terms.frequency[i] * point;
        std::array<double, 3> noises;
        add_corners(usable(p) ? p : Vec3(0), noises);
        for (std::size_t n = 0; n < 3; ++n)
            sum[n] = i == 0 ? noises[n] : sum[n] + terms.weight[i] * noises[n];
    }
}

/// Tables of Perlin's noise: unit vectors, and the indices that select them.
struct PerlinTables {
    static constexpr std::uint32_t count = 2048;
    std::array<Vec3, 2 * count + 2> gradients{};
    std::array<std::uint16_t, 2 * count + 2> indices{};

    PerlinTables() {
        NoiseSequence sequence(1);
        const auto component = [&] {
            return (static_cast<double>(sequence.next() & hash_mask) - 2048) / 2048;
        };
        for (std::size_t i = 0; i < count; ++i) {
            double square = 0;
            do {
                for (int axis = 0; axis < 3; ++axis) gradients[i][axis] = component();
                square = dot(gradients[i], gradients[i]);
            } while (square > 1 || square < 1e-5);
            gradients[i] /= std::sqrt(square);
        }
        // As in the original, the shuffle includes one entry too many: 0 occurs twice.
        for (std::uint32_t i = 0; i < count; ++i) indices[i] = static_cast<std::uint16_t>(i);
        for (std::uint32_t i = count; i > 0; i -= 2)
            std::swap(indices[i], indices[sequence.next() & (count - 1)]);
        for (std::uint32_t i = 0; i < count + 2; ++i) {
            indices[count + i] = indices[i];
            gradients[count + i] = gradients[i];
        }
    }
};

const PerlinTables& perlin_tables() {
    static const PerlinTables made;
    return made;
}

double perlin_noise(const Vec3& point) {
    const PerlinTables& table = perlin_tables();
    std::array<Place, 3> at;
    for (int axis = 0; axis < 3; ++axis) {
        const double t = point[axis] + 10000000.023157213;
        const double whole = std::floor(t), fraction = t - whole;
        const auto index = static_cast<std::uint32_t>(static_cast<std::int64_t>(whole));
        const double far = smooth(fraction);
        at[static_cast<std::size_t>(axis)] = {
            {index & (PerlinTables::count - 1), (index + 1) & (PerlinTables::count - 1)},
            {fraction, fraction - 1},
            {1 - far, far}};
    }
    double sum = 0;
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j) {
            const std::size_t ij = table.indices[table.indices[at[0].index[i]] + at[1].index[j]];
            for (std::size_t k = 0; k < 2; ++k)
                sum += at[0].weight[i] * at[1].weight[j] * at[2].weight[k] *
                       dot(table.gradients[ij + at[2].index[k]],
                           Vec3(at[0].offset[i], at[1].offset[j], at[2].offset[k]));
        }
    return sum;
}

double limited(double x) { return std::clamp(x, 0.0, 1.0); }

/// Maps to the range of the generator.
double in_range(double raw, NoiseGenerator generator) {
    return limited(generator == NoiseGenerator::original ? raw + 0.5
                                                         : (raw + 1.05242) * 0.48985582);
}

}  // namespace

NoiseGenerator noise_generator(double number) {
    // Numbers beyond the range of integers have no meaningful lowest bits.
    const auto bits = std::abs(number) < 2147483648.0 ? static_cast<std::int32_t>(number) & 3 : 0;
    return static_cast<NoiseGenerator>(std::max(bits, 1));
}

double noise(const Vec3& point, NoiseGenerator generator) {
    const Vec3 p = usable(point) ? point : Vec3(0);
    if (generator == NoiseGenerator::perlin) return limited(0.5 * (1.59 * perlin_noise(p) + 0.985));
    return in_range(raw_noise(p), generator);
}

void noises(const Vec3& point, std::span<const double> frequencies, NoiseGenerator generator,
            double* values) {
    if (generator == NoiseGenerator::perlin) {
        for (const double frequency : frequencies) *values++ = noise(frequency * point, generator);
        return;
    }
    raw_octaves(point, frequencies, values);
    for (std::size_t i = 0; i < frequencies.size(); ++i) values[i] = in_range(values[i], generator);
}

Vec3 vector_noise(const Vec3& point) {
    std::array<double, 3> noises;
    three_noises(usable(point) ? point : Vec3(0), noises);
    return {noises[0], noises[1], noises[2]};
}

Vec3 turbulence(const Vec3& point, const Octaves& octaves) {
    std::array<double, 3> sum;
    sum_octaves(point, OctaveTerms(octaves), sum);
    return {sum[0], sum[1], sum[2]};
}

double scalar_turbulence(const Vec3& point, const Octaves& octaves, NoiseGenerator generator) {
    // Generators of full range are stretched to the range of the original; only the first term is
    // clamped again.
    const bool original = generator == NoiseGenerator::original;
    const auto stretched = [&](double value) { return original ? value : 2 * value - 0.5; };
    const OctaveTerms terms(octaves);
    std::array<double, Octaves::most> values;
    noises(point, {terms.frequency.data(), terms.count}, generator, values.data());
    double sum = limited(stretched(values[0]));
    for (std::size_t i = 1; i < terms.count; ++i) sum += terms.weight[i] * stretched(values[i]);
    return sum;
}

std::uint32_t cell_hash(std::int64_t x, std::int64_t y, std::int64_t z) {
    const auto low = [](std::int64_t i) { return static_cast<std::uint32_t>(i) & hash_mask; };
    return tables.hash[tables.hash[tables.hash[low(x)] ^ low(y)] ^ low(z)];
}

std::span<const double> random_table() {
    static const std::vector<double> numbers = [] {
        std::vector<double> made(32768);
        std::mt19937 twister;
        for (double& number : made) number = twister() / 4294967296.0;
        return made;
    }();
    return numbers;
}

}  // namespace candelabra
