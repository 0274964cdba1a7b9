// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/dispersion.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace candelabra {

namespace {

/// Measured mean colours of POV-Ray's spectrum, in steps of 5 nm from 380 nm.
constexpr auto spectrum =
    std::array{Rgb(0.13942, 0, 0.52507), Rgb(0.20351, 0, 0.76343), Rgb(0.25185, 0, 0.98718),
               Rgb(0.28671, 0, 1.19631), Rgb(0.30133, 0, 1.40094), Rgb(0.31482, 0, 1.58196),
               Rgb(0.30807, 0, 1.74949), Rgb(0.28671, 0, 1.90352), Rgb(0.25185, 0, 2.05194),
               Rgb(0.21025, 0, 2.16999), Rgb(0.14054, 0, 2.28805), Rgb(0.06971, 0, 2.38699),
               Rgb(0, 0, 2.47132),       Rgb(0, 0, 2.54777),       Rgb(0, 0, 2.59725),
               Rgb(0, 0, 2.64672),       Rgb(0, 0, 2.66696),       Rgb(0, 0, 2.68719),
               Rgb(0, 0, 2.68832),       Rgb(0, 0, 2.6737),        Rgb(0, 0, 2.64672),
               Rgb(0, 0, 2.60399),       Rgb(0, 0, 2.54777),       Rgb(0, 0.31482, 2.47807),
               Rgb(0, 0.60153, 2.39374), Rgb(0, 0.87587, 2.29592), Rgb(0, 1.1266, 2.18461),
               Rgb(0, 1.36496, 2.05756), Rgb(0, 1.58871, 1.91814), Rgb(0, 1.79221, 1.7641),
               Rgb(0, 1.9811, 1.59545),  Rgb(0, 2.14188, 1.40768), Rgb(0, 2.30267, 1.21767),
               Rgb(0, 2.42972, 1.00742), Rgb(0, 2.54777, 0.77693), Rgb(0, 2.64559, 0.54643),
               Rgb(0, 2.72992, 0.28671), Rgb(0, 2.79288, 0.02136), Rgb(0.1754, 2.84235, 0),
               Rgb(0.51045, 2.87046, 0), Rgb(0.8264, 2.88396, 0),  Rgb(1.11985, 2.87721, 0),
               Rgb(1.39307, 2.84798, 0), Rgb(1.65167, 2.82099, 0), Rgb(1.87654, 2.75128, 0),
               Rgb(2.08567, 2.68832, 0), Rgb(2.26781, 2.5905, 0),  Rgb(2.44321, 2.47694, 0),
               Rgb(2.58263, 2.36001, 0), Rgb(2.70968, 2.21159, 0), Rgb(2.80638, 2.04407, 0),
               Rgb(2.8907, 1.87541, 0),  Rgb(2.95479, 1.67303, 0), Rgb(2.98852, 1.45603, 0),
               Rgb(3.00314, 1.23229, 0), Rgb(3.00314, 0.98043, 0), Rgb(2.96828, 0.71396, 0),
               Rgb(2.92556, 0.434, 0),   Rgb(2.86259, 0.13267, 0), Rgb(2.7659, 0, 0),
               Rgb(2.65234, 0, 0),       Rgb(2.52079, 0, 0),       Rgb(2.36563, 0, 0),
               Rgb(2.19136, 0, 0),       Rgb(1.9946, 0, 0),        Rgb(1.7776, 0, 0),
               Rgb(1.53361, 0, 0),       Rgb(1.27389, 0, 0),       Rgb(0.99392, 0, 0),
               Rgb(0.68585, 0, 0)};

}  // namespace

Rgb hue(const SpectralBand& band) {
    const double size = static_cast<double>(spectrum.size()) / band.count;
    const double begin = band.number * size, end = begin + size;
    Rgb sum(0);
    for (std::size_t i = 0; i < spectrum.size(); ++i) {
        const double from = static_cast<double>(i);
        const double share = std::min(end, from + 1) - std::max(begin, from);
        if (share > 0) sum += share * spectrum[i];
    }
    return sum / size;
}

}  // namespace candelabra
