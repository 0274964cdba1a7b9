// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the light of a world at the points of meters, by the integrator that makes its pictures.
// Neither clamps nor denoisers touch a result. All results are the same for any number of threads.
#pragma once

#include "meter/goal.h"
#include "meter/interval.h"
#include "meter/places.h"
#include "world/lamp.h"
#include "world/shot.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace candelabra {

/// Columns by which the light of lamps is told apart.
struct LampColumns {
    std::size_t count = 0;                      ///< 0: it is not told apart
    std::function<std::size_t(Lamp)> of = {};  ///< the column of a lamp; from `count` on: none
    /// Red, green and blue light have three columns, from that of the lamp on.
    bool in_colours = false;
};

struct MeasureSettings {
    int seed = 0;
    int threads = 0;  ///< 0: one per core
    int samples = 0;  ///< of each point, rounded up to equal batches; 0: as many as the goal needs
    /// The error of all values of a meter at which it is done.
    MeterGoal goal;
    /// Only for meters of illuminance and luminance.
    LampColumns lamps = {};
    /// True: stop after the round of samples under way.
    std::function<bool()> ended = {};
};

/// What one half of the batches has found, where lamps are told apart; in the unit of the quantity.
struct MeterHalf {
    std::vector<double> values;     ///< of each place, by all light
    std::vector<double> by_column;  ///< of each place and column; all columns of a place together
};

/// What one meter has found.
struct MeterReading {
    std::vector<MeterPlace> places;
    std::vector<MeterValue> values;  ///< of each place, in the unit of the quantity
    MeterSummary summary;            ///< of the places that are not left out; of all, if all are
    /// Numbers of the dark places inside of solids, which no meter could be put into.
    std::vector<std::size_t> left_out;
    double area = 0;        ///< of its grid in square metres; 0: it has none
    std::uint64_t samples;  ///< of each place
    bool reached = false;   ///< whether all values are as good as they were to be
    std::array<MeterHalf, 2> halves = {};
};

/// The luminance, over that of white, that an even sky would have to have for the illuminance of a
/// free horizontal plane: what daylight factors compare with.
double free_sky(const World&, const Vec3& up);

/// The reading of each meter, in their order. `shot` is that of any camera. Threshold increments
/// need the meter that they name. Precondition: no meter has a problem, and each has places.
std::vector<MeterReading> measure(const Shot&, std::span<const Meter>, const MeasureSettings&);

}  // namespace candelabra
