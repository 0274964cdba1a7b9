// SPDX-License-Identifier: GPL-3.0-or-later
// Limits the memory of the whole run, so that a scene that needs too much ends with a message
// rather than exhausting the machine. Called once at the start of a run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace candelabra {

/// Returns the memory of this machine in bytes, or nothing if the system does not tell.
std::optional<std::uint64_t> physical_memory();

/// Returns the default limit of a run in bytes: half of the free memory, within the limits of the
/// control groups of this process; nothing if the system does not tell. `root`: the folder with
/// proc and sys.
std::optional<std::uint64_t> usual_memory_limit(const std::string& root = "/");

/// Returns the resident memory of this process in bytes; 0 if the system does not tell.
std::uint64_t memory_in_use();

/// Whether twice the memory in use would be within the limit; without a limit, within the machine's
/// memory.
bool may_double(std::uint64_t in_use, std::optional<std::uint64_t> limit);

/// Lets allocations beyond this many bytes in total throw std::bad_alloc. Does not raise a lower
/// limit of the system.
void limit_memory(std::uint64_t bytes);

}  // namespace candelabra
