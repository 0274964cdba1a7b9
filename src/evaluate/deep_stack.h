// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a function on a thread with a stack as big as it is told, because scenes recurse deeper than
// the usual stack is. Memory is only taken as far as the stack is used.
#pragma once

#include "base/function_ref.h"

#include <cstddef>

/// Returns when the function has returned. It is told how many bytes of stack it has: less than
/// asked for, possibly.
void on_deep_stack(std::size_t bytes, FunctionRef<void(std::size_t)>);
