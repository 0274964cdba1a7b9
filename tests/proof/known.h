// SPDX-License-Identifier: GPL-3.0-or-later
// Faults that are known and not mended yet. A scene with these words that breaks the law counts as
// known, and is not reported again. The table is empty when there are none.
#pragma once

#include "proof/element.h"

#include <string_view>

namespace candelabra::proof {

/// The name of the known fault by which a scene may break the law; empty if there is none.
std::string_view known_fault(std::string_view law, const Script&);

}  // namespace candelabra::proof
