// SPDX-License-Identifier: GPL-3.0-or-later
// The adaptive scheme of Shirley and Wang (Figure 5): a few rays everywhere, more where the
// variance is high. It is unbiased, since the number of further rays of a pixel depends on its
// neighbours' samples, which are independent of its own.
#pragma once

#include "film/film.h"

namespace candelabra {

struct AdaptiveRule {
    double error;           ///< sufficient standard error: display values, summed over the channels
    std::uint32_t at_most;  ///< maximum samples of a pixel, including those it has
};

/// Returns the number of samples that the pixel needs besides those it has; 0 where its
/// neighbourhood is smooth.
std::uint32_t samples_to_add(const Film&, int x, int y, const AdaptiveRule&);

}  // namespace candelabra
