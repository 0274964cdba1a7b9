// SPDX-License-Identifier: GPL-3.0-or-later
// Runs independent jobs on several threads. Observable results do not depend on the number of
// threads. With one thread TBB is not even started: creating its workers takes longer than small
// scenes do.
#pragma once

#include <cstddef>
#include <functional>

namespace candelabra {

/// Calls job(0) ... job(count - 1), each once, on up to `threads` threads (0: one per core). Jobs
/// must not touch each other's data.
void run_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& job);

/// Calls work once; run_both() within it uses this many threads.
void run_on_threads(int threads, const std::function<void()>& work);

/// Calls both functions, in parallel unless `threads` is 1. Must be called within run_on_threads()
/// with the same number of threads.
void run_both(int threads, const std::function<void()>& first, const std::function<void()>& second);

/// The number of threads that `threads` = 0 stands for.
int core_count();

}  // namespace candelabra
