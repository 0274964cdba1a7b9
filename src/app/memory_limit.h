// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds the memory of the whole run, so that a scene that wants too much gets a message and not
// the machine's rescue. Called once at the start of a run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace candelabra {

/// The memory of this machine, or nothing if it does not tell.
std::optional<std::uint64_t> physical_memory();

/// How much a run may take when nothing is said: half of what is free now, for this process where
/// groups of control limit it; nothing if the system does not tell. `root`: where /proc and /sys
/// are.
std::optional<std::uint64_t> usual_memory_limit(const std::string& root = "/");

/// The memory that this process has at the moment; 0 if the system does not tell.
std::uint64_t memory_in_use();

/// Whether twice as much as is in use would still be allowed. Without a limit it is the machine's
/// memory.
bool may_double(std::uint64_t in_use, std::optional<std::uint64_t> limit);

/// From now on an allocation beyond this many bytes throws std::bad_alloc. Does nothing where the
/// system has a lower limit already.
void limit_memory(std::uint64_t bytes);

}  // namespace candelabra
