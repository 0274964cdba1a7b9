// SPDX-License-Identifier: GPL-3.0-or-later
// `candelabra merge`: joins the states that shards have left to the picture that a single run would
// have made, byte for byte. All sums are exact, so neither the order nor the partition matters.
#pragma once

#include "app/checkpoint.h"
#include "app/console.h"

#include <span>
#include <string_view>
#include <vector>

/// A state and the name of its file, for messages.
struct NamedState {
    std::string name;
    Checkpoint checkpoint;
};

/// What may be missing; it is said in any case.
enum class Gaps {
    none,
    around,    ///< samples before and behind those that are there, as a state can have it
    anywhere,  ///< as a picture can
};

/// The states as one. Nothing, after a report, when they are not of the same picture, overlap, or
/// leave out what may not be missing.
std::optional<Checkpoint> joined(std::vector<NamedState>, Gaps, Diagnostics&);

/// The arguments behind the word `merge`; gives the exit status.
int merge(std::span<const std::string_view> arguments, const Console&);
