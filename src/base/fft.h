// SPDX-License-Identifier: GPL-3.0-or-later
// Discrete Fourier transforms of planes of numbers in double precision. Used by the film, whose
// glare is a convolution with as wide a reach as the picture: a lamp may be ten million times as
// bright as what its glare falls on, so that the errors of single precision would be seen.
#pragma once

#include <cstddef>
#include <vector>

namespace candelabra {

struct Complex {
    double re = 0, im = 0;

    friend Complex operator+(Complex a, Complex b) { return {a.re + b.re, a.im + b.im}; }
    friend Complex operator-(Complex a, Complex b) { return {a.re - b.re, a.im - b.im}; }
    friend Complex operator*(Complex a, Complex b) {
        return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    }
    friend bool operator==(const Complex&, const Complex&) = default;
};

/// The least size that is no less, is even, and has no prime factors but 2, 3 and 5.
std::size_t fft_size(std::size_t at_least);

/// Numbers in rows.
struct ComplexPlane {
    std::size_t width = 0, height = 0;
    std::vector<Complex> values;

    ComplexPlane() = default;
    ComplexPlane(std::size_t w, std::size_t h) : width(w), height(h), values(w * h) {}
    Complex& at(std::size_t x, std::size_t y) { return values[y * width + x]; }
    const Complex& at(std::size_t x, std::size_t y) const { return values[y * width + x]; }
};

/// The transform, sum of value(x, y) exp(-2 pi i (u x / width + v y / height)), with u and v
/// exchanged: a column of the result is a row of frequencies. Sizes are those of fft_size().
/// `threads`: as in parallel.h; the result does not depend on them.
void transform_forward(ComplexPlane&, int threads);

/// The inverse, rows and columns exchanged back, and divided by the number of values: together with
/// the other it is the identity.
void transform_back(ComplexPlane&, int threads);

}  // namespace candelabra
