// SPDX-License-Identifier: GPL-3.0-or-later
// The light of each lamp at the points of meters, of which readings under other powers are made.
// What is no sum of the light of lamps, such as a rating of glare, is not kept.
#pragma once

#include "base/rgb.h"
#include "base/vector.h"
#include "relight/lamp_list.h"
#include "render/measure.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace candelabra {

struct KeptMeter {
    std::string name, quantity, unit;  ///< names of the language, see name_of(Quantity)
    std::vector<Vec3> points;
    std::vector<float> rest;   ///< of each point, in the unit: light without a lamp
    std::vector<float> light;  ///< of each point and node: by the red, green and blue light of it

    friend bool operator==(const KeptMeter&, const KeptMeter&) = default;
};

struct KeptMeters {
    std::vector<LampRange> nodes;  ///< one behind the other, with all lamps; lamps by themselves
                                   ///< unless they and the points are too many
    std::vector<KeptMeter> meters;

    friend bool operator==(const KeptMeters&, const KeptMeters&) = default;
};

/// Whether the readings of a meter are sums of the light of lamps.
bool is_sum_of_lamps(const Meter&);

/// The nodes by which light is told apart at so many points.
std::vector<LampRange> nodes_for_points(const LampList&, std::size_t points);

/// What meters have read; their columns are three for each of the nodes.
KeptMeters kept_meters(std::span<const Meter>, std::span<const MeterReading>,
                       std::vector<LampRange> nodes);

/// The reading of each point of a meter, with these factors on the lamps.
std::vector<double> relit_readings(const KeptMeters&, const KeptMeter&, const LampList&,
                                   std::span<const Rgb> factors);

}  // namespace candelabra
