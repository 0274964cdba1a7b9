// SPDX-License-Identifier: GPL-3.0-or-later
// `candelabra merge`: joins the states of shards to the picture that a single run would have made,
// byte for byte. All sums are exact, so neither the order nor the partition matters. States are
// added one by one, so any number needs no more memory than two.
#pragma once

#include "console/console.h"

#include <span>
#include <string_view>

namespace candelabra {

/// `arguments`: those after `merge`. Returns the exit status.
int merge(std::span<const std::string_view> arguments, const Console&);

}  // namespace candelabra
