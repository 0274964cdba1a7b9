// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's adaptive scheme (Figure 5): a few rays everywhere, more where the variance is high.
// Without bias: how many more rays a pixel gets is decided by its neighbours' samples, which are
// independent of its own.
#pragma once

#include "film/film.h"

namespace candelabra {

struct AdaptiveRule {
    double error;  ///< standard error that is good enough: display values, summed over the channels
    std::uint32_t at_most;  ///< samples of a pixel, with those that it has
};

/// Samples that the pixel needs beside those it has; 0 where its neighbourhood is smooth.
std::uint32_t samples_to_add(const Film&, int x, int y, const AdaptiveRule&);

}  // namespace candelabra
