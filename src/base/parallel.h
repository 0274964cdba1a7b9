// SPDX-License-Identifier: GPL-3.0-or-later
// Runs independent jobs on several threads. Nothing that a caller can observe depends on their
// number. With one thread TBB is not even started: its search for helpers takes longer than small
// scenes do.
#pragma once

#include <cstddef>
#include <functional>

namespace candelabra {

/// Calls job(0) ... job(count - 1), each once, on up to `threads` threads (0: one per core). Jobs
/// must not touch each other's data.
void run_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& job);

/// Calls work once; what it runs by run_both() uses that many threads.
void run_on_threads(int threads, const std::function<void()>& work);

/// Calls both, side by side unless `threads` is 1. Called inside of run_on_threads() with the same
/// number of threads.
void run_both(int threads, const std::function<void()>& first, const std::function<void()>& second);

/// The number of threads that `threads` = 0 stands for.
int core_count();

}  // namespace candelabra
