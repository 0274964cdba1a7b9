// SPDX-License-Identifier: GPL-3.0-or-later
// Where the light of lamps ends: on surfaces, in the air, or outside of the scene. Light paths
// start at luminaires and at light sources with a flux, and every reflection is followed, whatever
// the scene's integrator does.
#pragma once

#include "meter/interval.h"
#include "world/shot.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace candelabra {

/// The ends of light. "Reflected" light has been mirrored, refracted or reflected diffusely before.
enum class LightEnd : std::uint8_t {
    surfaces,         ///< absorbed by surfaces, or inside of solids
    air,              ///< absorbed by fog and media, or scattered by them
    above,            ///< leaves the scene above the horizon, straight from its lamp
    above_reflected,  ///< leaves it above the horizon
    below,            ///< leaves it below the horizon, straight from its lamp
    below_reflected,
    unknown  ///< still on its way after as many surfaces as a path may meet
};
inline constexpr std::size_t light_ends = 7;

/// Luminance times area, which LightUnits::lumens() converts.
struct LampBalance {
    std::size_t lamps = 0;
    MeterValue sent;
    std::array<MeterValue, light_ends> ends;

    const MeterValue& of(LightEnd end) const { return ends[static_cast<std::size_t>(end)]; }
};

/// Light that the objects of one statement absorb.
struct ObjectBalance {
    Span statement;
    MeterValue absorbed;
};

struct LightBalance {
    std::vector<LampBalance> lamps;  ///< of each of Provenance::light_statements
    LampBalance all;
    /// In order of the amount. Empty unless compile() was told to remember objects.
    std::vector<ObjectBalance> objects;
    std::uint64_t paths = 0;
    bool reached = false;  ///< whether all errors are as small as they were to be
};

struct BalanceSettings {
    int seed = 0;
    int threads = 0;          ///< 0: one per core; the result is the same
    Vec3 up = Vec3(0, 1, 0);  ///< horizontal directions are perpendicular to it; not 0
    /// The error of all ends of the light of each statement, relative to all light, at which the
    /// balance is done.
    double error = 0.005;
    /// Paths of each lamp in the mean, rounded up to equal batches; 0: as many as the error
    /// needs.
    int samples = 0;
    /// True: stop after the round of paths under way.
    std::function<bool()> ended = {};
};

/// The light of the sky is left out, and that of light sources without a flux: see sends_flux().
LightBalance balance_of_light(const Shot&, const BalanceSettings&);

}  // namespace candelabra
