// SPDX-License-Identifier: GPL-3.0-or-later
// Internal functions made of noise: the noise itself, and Musgrave's multifractal sums, which
// resemble mountains. Called through the table in internal.cpp. Arguments are x, y, z, then p0, p1,
// ...
#pragma once

namespace candelabra {

namespace formula {

/// Maximum number of octaves that are added; further ones are too faint to be visible.
inline constexpr int max_octaves = 100;

double hetero_mf(const double* arguments);
double ridge(const double* arguments);
/// POV-Ray 3.7 keeps the octave weights of the first call of any f_ridged_mf, whatever later calls
/// ask for. Here each call computes its own.
double ridged_mf(const double* arguments);
double noise3d(const double* arguments);
double noise_of_generator(const double* arguments);

}  // namespace formula

}  // namespace candelabra
