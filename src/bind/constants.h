// SPDX-License-Identifier: GPL-3.0-or-later
// Which elements of a file are sure to make again what they have made before: blocks and values of
// numbers and words only, without names, calls and directives. A loop that places a million spheres
// meets their `pigment { rgb 1 }` a million times. Called by the readers of objects, textures and
// transforms.
#pragma once

#include "interpret/evaluator.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace candelabra {

class Constants {
public:
    /// A number for an element that has been met before and is constant; the same each time. None
    /// for all others, also for a constant one that is met for the first time: most never come
    /// again.
    std::optional<std::uint64_t> number(const Element&);

private:
    enum class Known : std::uint8_t { nothing, met, constant, variable };

    std::vector<std::vector<Known>> nodes_;  ///< by source, by node
};

/// Whether the node can have one value or meaning only. Large ones are not looked through: for
/// them, the answer is no.
bool is_constant(const Tree&, NodeId);
/// The same when names mean what they mean now: they are added to `names`.
bool is_constant_but_names(const Tree&, NodeId, std::vector<NameId>& names);

}  // namespace candelabra
