// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/fft.h"

#include "base/elementary.h"
#include "base/parallel.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

namespace candelabra {

namespace {

constexpr auto radices = std::array<std::size_t, 4>{4, 2, 3, 5};
constexpr std::size_t max_radix = 5;

/// Transforms rows of one length by Stockham's scheme: each stage reads one row and writes another,
/// and the final order is correct without a permutation.
class RowTransform {
public:
    explicit RowTransform(std::size_t length) : roots_(length) {
        for (std::size_t i = 0; i < length; ++i) {
            const double angle =
                -2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(length);
            roots_[i] = {math::cos(angle), math::sin(angle)};
        }
        for (std::size_t rest = length; rest > 1;)
            for (const std::size_t radix : radices)
                if (rest % radix == 0) {
                    stages_.push_back(radix);
                    rest /= radix;
                    break;
                }
    }

    /// `other` is working space as large as the row.
    void operator()(Complex* row, Complex* other) const {
        Complex *from = row, *to = other;
        std::size_t rest = roots_.size(), stride = 1;
        for (const std::size_t radix : stages_) {
            rest /= radix;
            if (radix == 2)
                stage_of_two(from, to, rest, stride);
            else if (radix == 4)
                stage_of_four(from, to, rest, stride);
            else
                stage(from, to, rest, stride, radix);
            stride *= radix;
            std::swap(from, to);
        }
        if (from != row) std::copy(from, from + roots_.size(), row);
    }

private:
    void stage_of_two(const Complex* from, Complex* to, std::size_t rest,
                      std::size_t stride) const {
        for (std::size_t p = 0; p < rest; ++p) {
            const Complex w = roots_[p * stride];
            for (std::size_t q = 0; q < stride; ++q) {
                const Complex a = from[q + stride * p], b = from[q + stride * (p + rest)];
                to[q + stride * 2 * p] = a + b;
                to[q + stride * (2 * p + 1)] = (a - b) * w;
            }
        }
    }

    void stage_of_four(const Complex* from, Complex* to, std::size_t rest,
                       std::size_t stride) const {
        for (std::size_t p = 0; p < rest; ++p) {
            const Complex w1 = roots_[p * stride], w2 = roots_[2 * p * stride],
                          w3 = roots_[3 * p * stride];
            for (std::size_t q = 0; q < stride; ++q) {
                const Complex a = from[q + stride * p], b = from[q + stride * (p + rest)],
                              c = from[q + stride * (p + 2 * rest)],
                              d = from[q + stride * (p + 3 * rest)];
                const Complex even = a + c, odd = a - c, sum = b + d, turned = b - d;
                const Complex side = {turned.im, -turned.re};
                Complex* const out = to + q + stride * 4 * p;
                out[0] = even + sum;
                out[stride] = (odd + side) * w1;
                out[2 * stride] = (even - sum) * w2;
                out[3 * stride] = (odd - side) * w3;
            }
        }
    }

    void stage(const Complex* from, Complex* to, std::size_t rest, std::size_t stride,
               std::size_t radix) const {
        const std::size_t size = roots_.size(), step = size / radix;
        for (std::size_t p = 0; p < rest; ++p)
            for (std::size_t q = 0; q < stride; ++q) {
                std::array<Complex, max_radix> in;
                for (std::size_t k = 0; k < radix; ++k) in[k] = from[q + stride * (p + rest * k)];
                for (std::size_t j = 0; j < radix; ++j) {
                    Complex sum = in[0];
                    for (std::size_t k = 1; k < radix; ++k)
                        sum = sum + in[k] * roots_[j * k % radix * step];
                    to[q + stride * (radix * p + j)] = sum * roots_[p * j * stride];
                }
            }
    }

    std::vector<Complex> roots_;
    std::vector<std::size_t> stages_;
};

/// Number of rows that one thread takes at a time.
constexpr std::size_t rows_at_once = 16;

void transform_rows(ComplexPlane& plane, int threads) {
    const RowTransform transform(plane.width);
    run_parallel((plane.height + rows_at_once - 1) / rows_at_once, threads, [&](std::size_t part) {
        std::vector<Complex> room(plane.width);
        const std::size_t end = std::min(plane.height, (part + 1) * rows_at_once);
        for (std::size_t y = part * rows_at_once; y < end; ++y)
            transform(&plane.at(0, y), room.data());
    });
}

ComplexPlane transposed(const ComplexPlane& plane, int threads) {
    ComplexPlane result(plane.height, plane.width);
    run_parallel((plane.width + rows_at_once - 1) / rows_at_once, threads, [&](std::size_t part) {
        const std::size_t end = std::min(plane.width, (part + 1) * rows_at_once);
        for (std::size_t y = 0; y < plane.height; ++y)
            for (std::size_t x = part * rows_at_once; x < end; ++x)
                result.at(y, x) = plane.at(x, y);
    });
    return result;
}

void transform_both(ComplexPlane& plane, int threads) {
    transform_rows(plane, threads);
    plane = transposed(plane, threads);
    transform_rows(plane, threads);
}

}  // namespace

std::size_t fft_size(std::size_t at_least) {
    for (std::size_t size = std::max<std::size_t>(at_least + at_least % 2, 2);; size += 2) {
        std::size_t rest = size;
        for (const std::size_t prime : {2u, 3u, 5u})
            while (rest % prime == 0) rest /= prime;
        if (rest == 1) return size;
    }
}

void transform_forward(ComplexPlane& plane, int threads) { transform_both(plane, threads); }

void transform_back(ComplexPlane& plane, int threads) {
    // The inverse is the transform of the conjugate, conjugated.
    for (Complex& value : plane.values) value.im = -value.im;
    transform_both(plane, threads);
    const double share = 1 / static_cast<double>(plane.values.size());
    for (Complex& value : plane.values) value = {value.re * share, -value.im * share};
}

}  // namespace candelabra
