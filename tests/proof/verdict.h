// SPDX-License-Identifier: GPL-3.0-or-later
// Checks claims: few samples first, more for the suspicious. A claim fails only if three tests with
// fresh noise fail in the same region and direction; see stages in verdict.cpp for the probability
// of a false alarm.
#pragma once

#include "proof/law.h"

#include <optional>

namespace candelabra::proof {

enum class Outcome {
    holds,
    fails,
    undecided,  ///< suspicious, but the noise is too skewed to tell in the time
    too_slow,
    illegal
};

struct Verdict {
    Outcome outcome = Outcome::holds;
    std::string claim = {};
    double left = 0, right = 0;  ///< means of the region
    double t = 0;
    std::string said = {};  ///< region, samples, complaint
};

/// The worst verdict over all claims of a law on the script.
Verdict judged(const Law&, const Script&, std::uint64_t seed, const Studio&);

/// A sentence.
std::string described(const Verdict&);

}  // namespace candelabra::proof
