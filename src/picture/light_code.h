// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of light in few bytes, for pages that show them in a browser (src/preview/page/share.js
// has the decoder). Each channel is kept as a logarithm, which has 16 bits when it is read. The
// pictures lose what is finer than a step.
//
// A value v becomes log2(1 + 64 v). Brightness (R + 2 G + B) / 4 and the colours R - B and
// G - (R + B) / 2 of these logarithms go through the wavelet transform CDF 9/7 (A. Cohen, I.
// Daubechies and J.-C. Feauveau, 1992; by the lifting of I. Daubechies and W. Sweldens, 1998),
// scaled to be nearly orthonormal. A coefficient is divided by the step, for colours by twice the
// step, and rounded up from 0.6 on. Whole numbers n follow as 2 n or, below 0, as -2 n - 1, plane
// by plane and from coarse to fine, in a byte each, or, from 255 on, as 255 and four bytes from the
// lowest on. zlib packs them.
#pragma once

#include "base/image.h"

#include <cstddef>
#include <span>
#include <string>

namespace candelabra {

/// The factor on values before the logarithm: below 1/64, steps are even.
inline constexpr double light_code_gain = 64;

struct LightCode {
    int levels = 0;     ///< of the wavelet transform
    double step = 0;    ///< of brightness, as a logarithm to the base 2
    std::string bytes;  ///< all pictures, packed by zlib
};

/// The smallest step: finer than a display with 10 bits shows.
inline constexpr double finest_light_step = 1.0 / 128;

/// Codes pictures of the same size with a step above 0. Values below 0 and NaN count as 0. The
/// result does not depend on the number of threads.
LightCode light_code(std::span<const Image>, double step, int threads = 1);

/// Codes pictures of the same size with the smallest step, from finest_light_step on, with which
/// they have about this many bytes and at most as many. Pictures that are too many have more bytes
/// with any step; then the step is the greatest, 8.
LightCode light_code_within(std::span<const Image>, std::size_t most_bytes, int threads = 1);

}  // namespace candelabra
