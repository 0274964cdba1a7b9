// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula/fractal_noise.h"

#include "base/elementary.h"
#include "base/noise.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace formula {

namespace {

Vec3 point_of(const double* arguments) { return {arguments[0], arguments[1], arguments[2]}; }

double limited_octaves(double number) {
    return std::clamp(number, 0.0, static_cast<double>(max_octaves));
}

}  // namespace

double hetero_mf(const double* arguments) {
    const double* p = arguments + 3;
    const double roughness = p[0], lacunarity = p[1], offset = p[3];
    const double octaves = limited_octaves(p[2]);
    const NoiseGenerator generator = noise_generator(p[5]);
    Vec3 at = point_of(arguments);
    const auto height = [&] { return 2 * noise(at, generator) - 1 + offset; };

    const double fading = math::pow(lacunarity, -roughness), times = std::trunc(p[4]);
    double sum = height(), weight = 1;
    const auto next = [&] {
        at *= lacunarity;
        weight *= fading;
        return height() * weight;
    };
    for (int i = 1; i < octaves; ++i) {
        const double more = next();
        sum += times > 1 ? more * math::pow(sum, times) : times == 1 ? more * sum : more;
    }
    // A partial octave has already been added in full; one more is added by the fraction.
    const double fraction = octaves - std::floor(octaves);
    if (fraction != 0) sum += fraction * sum * next();
    return sum;
}

double ridge(const double* arguments) {
    const double* p = arguments + 3;
    const double lambda = p[0], omega = p[2], offset = p[3], crest = p[4];
    const double octaves = limited_octaves(p[1]);
    const double whole = std::floor(octaves);
    const NoiseGenerator generator = noise_generator(p[5]);
    Vec3 at = point_of(arguments);
    const auto height = [&] {
        return std::abs(noise(at, generator) - crest) / std::max(crest, 1 - crest) - offset;
    };

    double sum = height(), total = 1, weight = 1;
    const auto add = [&](double share) {
        at *= lambda;
        weight *= omega;
        sum += share * weight * height();
        total += share * weight;
    };
    for (int i = 1; i < whole; ++i) add(1);
    if (octaves != whole) add(octaves - whole);
    return sum / (total * std::max(offset, 1 - offset));
}

double ridged_mf(const double* arguments) {
    const double* p = arguments + 3;
    const double roughness = p[0], lacunarity = p[1], offset = p[3], gain = p[4];
    const double octaves = limited_octaves(p[2]);
    const NoiseGenerator generator = noise_generator(p[5]);
    Vec3 at = point_of(arguments);
    const auto crest = [&] {
        const double signal = offset - std::abs(2 * noise(at, generator) - 1);
        return signal * signal;
    };

    const double fading = math::pow(lacunarity, -roughness);
    double signal = crest(), sum = signal, weight = 1;
    for (int i = 1; i < octaves; ++i) {
        at *= lacunarity;
        weight *= fading;
        signal = std::clamp(signal * gain, 0.0, 1.0) * crest();
        sum += signal * weight;
    }
    return sum;
}

double noise3d(const double* arguments) {
    return noise(point_of(arguments), NoiseGenerator::full_range);
}

double noise_of_generator(const double* arguments) {
    return noise(point_of(arguments), noise_generator(arguments[3]));
}

}  // namespace formula

}  // namespace candelabra
