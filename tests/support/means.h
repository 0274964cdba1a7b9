// SPDX-License-Identifier: GPL-3.0-or-later
// Means of what rays see, with their standard errors: for laws such as "the light of two lamps adds
// up", or "light that is sampled is that which is found by chance".
#pragma once

#include "support/scripts.h"
#include "transport/integrator.h"

#include <cmath>
#include <string>

namespace candelabra {

/// The mean of many samples, and its standard error.
struct Mean {
    double value = 0, error = 0;

    Mean operator+(const Mean& other) const {
        return {value + other.value, std::hypot(error, other.error)};
    }
};

/// Whether two means of independent samples agree, but for a fraction of the first one.
inline bool agree(const Mean& a, const Mean& b, double fraction = 0) {
    constexpr double errors = 4.5;
    return std::abs(a.value - b.value) <=
           errors * std::hypot(a.error, b.error) + fraction * std::abs(a.value);
}

/// The mean of what a ray sees, in grey.
inline Mean mean_seen(const Shot& shot, const Ray& ray, std::uint32_t count) {
    Integrator integrator(shot, {});
    double sum = 0, squares = 0;
    Key key;
    for (key.sample = 0; key.sample < count; ++key.sample) {
        const double seen = grey(integrator.radiance(ray, key));
        sum += seen, squares += seen * seen;
    }
    const double mean = sum / count;
    return {mean, std::sqrt(std::fmax(squares / count - mean * mean, 0) / count)};
}

inline Mean mean_seen(const std::string& script, const Ray& ray, std::uint32_t count) {
    // The camera says which solids contain the ray's origin.
    const auto number = [&](int axis) { return std::to_string(ray.origin[axis]); };
    return mean_seen(shot_of(script + " camera { location <" + number(0) + ", " + number(1) + ", " +
                             number(2) + "> } "),
                     ray, count);
}

}  // namespace candelabra
