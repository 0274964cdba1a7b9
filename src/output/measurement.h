// SPDX-License-Identifier: GPL-3.0-or-later
// The results of meters as tables, for --measure.
#pragma once

#include "meter/meter.h"
#include "render/measure.h"
#include "text/diagnostic.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace candelabra {

enum class ReadingFormat { csv, json };

/// Returns the format for the extension of the file's name, ignoring case; CSV for standard output,
/// "-"; nothing for others.
std::optional<ReadingFormat> reading_format(std::string_view file);

/// Reports what cannot be measured, and warns of what is measured otherwise than people expect.
void review_meters(const World&, std::span<const Meter>, Diagnostics&);

/// What the results were measured with.
struct MeasuredScene {
    std::span<const Meter> meters;
    std::span<const MeterReading> readings;  ///< of each meter
    LightUnits units;
    int seed = 0;
};

/// Warns of results that are not as exact as the goal wants, and of points that no light reaches.
void review_readings(const MeasuredScene&, const MeterGoal&, Diagnostics&);

/// Warns of points inside of objects, which count in no summary and have no value in tables.
void review_places(const MeasuredScene&, Diagnostics&);

/// Returns a row for each point, with the bounds of the 95 % interval.
std::string readings_as_csv(const MeasuredScene&);
/// The same, with what follows of all points of each meter.
std::string readings_as_json(const MeasuredScene&);
/// Returns what follows of all points of each meter, for people.
std::string readings_as_text(const MeasuredScene&);

}  // namespace candelabra
