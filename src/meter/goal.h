// SPDX-License-Identifier: GPL-3.0-or-later
// How good results have to be, as --until says.
#pragma once

#include "meter/meter.h"

#include <optional>
#include <string_view>

namespace candelabra {

struct MeterGoal {
    double error = 0.02;  ///< half of the 95 % interval, relative to the value
    /// What counts: the unit, or the name of a quantity; empty: all meters.
    std::string_view what = {};

    bool counts(Quantity) const;
};

/// Reads `2%`, `lux 2%`, `nit 1%` or the name of a quantity before the number; nothing for other
/// texts. The goal refers to constants only.
std::optional<MeterGoal> read_meter_goal(std::string_view text);

}  // namespace candelabra
