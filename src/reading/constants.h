// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the elements of a file that yield the same result each time: blocks and values that consist
// of numbers and words only, without names, calls and directives. A loop that places a million
// spheres reads their `pigment { rgb 1 }` a million times. Called by the readers of objects,
// textures and transforms.
#pragma once

#include "interpret/evaluator.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace candelabra {

class Constants {
public:
    /// A number that identifies a constant element from its second visit on. Returns nothing for
    /// variable elements, and at the first visit, because most elements are never visited again.
    std::optional<std::uint64_t> number(const Element&);

private:
    enum class Known : std::uint8_t { nothing, met, constant, variable };

    std::vector<std::vector<Known>> nodes_;  ///< by source, by node
};

/// Whether the node always has the same value or meaning. False for nodes that are too large to
/// search.
bool is_constant(const Tree&, NodeId);
/// The same if names keep their current meaning; appends those names to `names`.
bool is_constant_but_names(const Tree&, NodeId, std::vector<NameId>& names);

}  // namespace candelabra
