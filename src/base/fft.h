// SPDX-License-Identifier: GPL-3.0-or-later
// Discrete Fourier transforms of planes in double precision. Used by the film for glare, a
// convolution as wide as the picture. A lamp may be ten million times as bright as the pixels under
// its glare, so that the errors of single precision would be visible.
#pragma once

#include "base/complex.h"

#include <cstddef>
#include <vector>

namespace candelabra {

/// The smallest even size, not below `at_least`, without prime factors other than 2, 3 and 5.
std::size_t fft_size(std::size_t at_least);

/// A plane of complex numbers in rows.
struct ComplexPlane {
    std::size_t width = 0, height = 0;
    std::vector<Complex> values;

    ComplexPlane() = default;
    ComplexPlane(std::size_t w, std::size_t h) : width(w), height(h), values(w * h) {}
    Complex& at(std::size_t x, std::size_t y) { return values[y * width + x]; }
    const Complex& at(std::size_t x, std::size_t y) const { return values[y * width + x]; }
};

/// Computes sum of value(x, y) exp(-2 pi i (u x / width + v y / height)) with u and v exchanged: a
/// column of the result is a row of frequencies. Sizes must be those of fft_size(). `threads` is as
/// in parallel.h; the result does not depend on it.
void transform_forward(ComplexPlane&, int threads);

/// Computes the inverse: exchanges rows and columns back, and divides by the number of values.
/// Together with transform_forward() it is the identity.
void transform_back(ComplexPlane&, int threads);

}  // namespace candelabra
