// SPDX-License-Identifier: GPL-3.0-or-later
// What tasks that measure light have in common: their end, and their table.
#pragma once

#include "render/measure.h"
#include "tasks/scene_steps.h"

#include <functional>
#include <string>

namespace candelabra {

/// Returns whether measuring is to end: the time is over, or a signal has come, which sets
/// `stopped`. Both must outlive the function.
std::function<bool()> ends_measuring(const SceneSteps&, bool& stopped);

/// The settings of meters by the options. They end as ends_measuring() says.
MeasureSettings measure_settings(const SceneSteps&, bool& stopped);

/// Reports what does not go together with measuring, which includes balances of light.
void check_measuring(const Options&, Diagnostics&);

/// Warns of a scene that moves while its shutter is open: what is measured is its first moment.
void review_moments(const Shot&, const Options&, Diagnostics&);

/// Whether the table is to be JSON; otherwise it is CSV.
bool measures_as_json(const Options&);

/// Writes the table to the file of the options, and prints the text, which is for people. Returns
/// the exit status.
int write_measured(SceneSteps&, const std::string& table, const std::string& text, bool stopped);

}  // namespace candelabra
