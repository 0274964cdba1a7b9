// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a function on a thread with a stack as big as it is told, because scenes recurse deeper than
// the usual stack is. Memory is only taken as far as the stack is used. The program does all its
// work on a scene so; the evaluator, which tests call alone, finds itself on such a stack or asks
// for one.
#pragma once

#include "base/function_ref.h"

#include <cstddef>

namespace candelabra {

/// Returns when the function has returned, and throws what it throws. It is told how many bytes of
/// stack it has: less than asked for, possibly. Where half of that is left on a thread of this
/// kind, it runs there.
void on_deep_stack(std::size_t bytes, FunctionRef<void(std::size_t)>);

}  // namespace candelabra
