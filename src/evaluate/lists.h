// SPDX-License-Identifier: GPL-3.0-or-later
// Lists that say how long they are: { count, value, value, ... }. Called by the ItemReader for
// mesh2's lists.
#pragma once

#include "evaluate/block.h"

#include <optional>

/// The list as a field of the type has it; nothing after a report.
std::optional<FieldValue> read_counted_list(OpenBlock&, Body, FieldType);
