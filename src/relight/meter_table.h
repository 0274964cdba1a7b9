// SPDX-License-Identifier: GPL-3.0-or-later
// The readings of meters under other powers of lamps, as CSV.
#pragma once

#include "base/rgb.h"
#include "relight/light_records.h"

#include <span>
#include <string>
#include <string_view>

namespace candelabra {

inline constexpr std::string_view relit_readings_head = "meter,quantity,unit,point,x,y,z,value\n";

/// Returns a row for each point of each meter, each with `begin` before it.
std::string relit_readings(const LightRecords&, std::span<const Rgb> factors,
                           std::string_view begin);

}  // namespace candelabra
