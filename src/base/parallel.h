// SPDX-License-Identifier: GPL-3.0-or-later
// Runs independent jobs on several threads. Nothing that a caller can observe depends on their
// number.
#pragma once

#include <cstddef>
#include <functional>

/// Calls job(0) ... job(count - 1), each once, on up to `threads` threads (0: one per core). Jobs
/// must not touch each other's data.
void run_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& job);

/// Calls work once; parallel work that it starts, in whatever way, runs on that many threads.
void run_on_threads(int threads, const std::function<void()>& work);

/// The number of threads that `threads` = 0 stands for.
int core_count();
