// SPDX-License-Identifier: GPL-3.0-or-later
// The task of `candelabra solve`: powers of lamps with which meters read what they are to.
#pragma once

#include "solver/linear_programme.h"
#include "tasks/scene_steps.h"

#include <string>
#include <vector>

namespace candelabra {

/// What a meter is to read, in lux: at each of its points, or in their mean.
struct MeterDemand {
    std::string meter;
    double low = 0;
    double high = LinearProgramme::unbounded;
    bool of_mean = false;
};

struct SolveRequest {
    std::vector<MeterDemand> demands;
    std::vector<std::string> lamps;  ///< names as LampNames has them; empty: all except the sky
    bool together = false;           ///< the lamps of a name share a power
    double most = LinearProgramme::unbounded;  ///< power, in terms of that of the scene
};

/// Solves, writes the powers to Options::readings_file, and prints a report. Powers that miss some
/// bounds are written, too, but the status is that of an error. Returns the exit status.
int solve_powers(SceneSteps&, const SolveRequest&);

}  // namespace candelabra
