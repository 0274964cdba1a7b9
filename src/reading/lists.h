// SPDX-License-Identifier: GPL-3.0-or-later
// Reads lists that begin with their length: { count, value, value, ... }. Called by ItemReader for
// mesh2's lists.
#pragma once

#include "reading/block.h"

#include <optional>

namespace candelabra {

struct CountedList {
    FieldValue value;
    /// Of faces: texture numbers of their corners; empty: none are given.
    std::vector<Face> looks;
};

/// Reads the list as a value of the field's type; returns nothing after a diagnostic.
std::optional<CountedList> read_counted_list(OpenBlock&, Body, FieldType);

}  // namespace candelabra
