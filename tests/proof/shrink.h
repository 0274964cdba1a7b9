// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a script small that breaks a law: leaves elements out, puts parts in the place of what is
// around them, and simplifies shapes and textures, as long as the law stays broken (Zeller and
// Hildebrandt, Simplifying and isolating failure-inducing input, 2002).
#pragma once

#include "proof/element.h"

#include <functional>

namespace candelabra::proof {

/// `broken`: whether the smaller script still shows the fault.
Script shrunk(Script, const std::function<bool(const Script&)>& broken);

}  // namespace candelabra::proof
