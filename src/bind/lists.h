// SPDX-License-Identifier: GPL-3.0-or-later
// Lists that say how long they are: { count, value, value, ... }. Called by the ItemReader for
// mesh2's lists.
#pragma once

#include "bind/block.h"

#include <optional>

namespace candelabra {

struct CountedList {
    FieldValue value;
    /// Of faces: numbers of their corners' textures; empty: none is given.
    std::vector<Face> looks;
};

/// The list as a field of the type has it; nothing after a report.
std::optional<CountedList> read_counted_list(OpenBlock&, Body, FieldType);

}  // namespace candelabra
