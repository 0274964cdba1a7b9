// SPDX-License-Identifier: GPL-3.0-or-later
// `candelabra merge`: joins the states that shards have left to the picture that a single run would
// have made, byte for byte. All sums are exact, so neither the order nor the partition matters; one
// state after the other is added, so that any number needs no more memory than two.
#pragma once

#include "app/console.h"

#include <span>
#include <string_view>

namespace candelabra {

/// The arguments behind the word `merge`; gives the exit status.
int merge(std::span<const std::string_view> arguments, const Console&);

}  // namespace candelabra
