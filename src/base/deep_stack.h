// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a function on a thread with a stack of a given size, because scenes recurse deeper than the
// usual stack allows. Memory is only committed as far as the stack is used. The program does all
// its work on a scene in this way. The evaluator, which tests call by itself, uses the deep stack
// that it is on, or requests one.
#pragma once

#include "base/function_ref.h"

#include <cstddef>
#include <cstdint>

namespace candelabra {

/// Returns when the function has returned, and rethrows its exceptions. The function gets the size
/// of its stack in bytes, which may be less than requested. If the calling thread is of this kind
/// and has half of the size left, the function runs on it.
void on_deep_stack(std::size_t bytes, FunctionRef<void(std::size_t)>);

/// How much a limit on the memory of the process counts of such a stack, in bytes.
std::uint64_t memory_of_deep_stack(std::size_t bytes);

}  // namespace candelabra
