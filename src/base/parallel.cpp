// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/parallel.h"

#include "base/work_watch.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>

namespace candelabra {

namespace {

/// Calls work() on a thread that helps another one, for which that is asked; null: nothing.
template <class Work>
void help(const std::function<bool()>* ended, const Work& work) {
    if (!ended || WorkWatch::for_helpers() == ended) return work();
    const WorkWatch watch(*ended, WorkWatch::Asks::everywhere);
    work();
}

}  // namespace

int core_count() { return oneapi::tbb::this_task_arena::max_concurrency(); }

void run_on_threads(int threads, const std::function<void()>& work) {
    if (threads == 1) return work();
    // More threads than cores gain nothing, and very many would only contend with each other.
    threads = threads <= 0 ? core_count() : std::min(threads, 4 * core_count());
    using Control = oneapi::tbb::global_control;
    const Control allowed(Control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    oneapi::tbb::task_arena arena(threads);
    arena.execute(work);
}

void run_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& job) {
    if (threads == 1) {
        for (std::size_t i = 0; i < count; ++i) job(i);
        return;
    }
    const std::function<bool()>* ended = WorkWatch::for_helpers();
    run_on_threads(threads, [&] {
        oneapi::tbb::parallel_for(
            std::size_t{0}, count, [&](std::size_t i) { help(ended, [&] { job(i); }); },
            oneapi::tbb::simple_partitioner());
    });
}

void run_both(int threads, const std::function<void()>& first,
              const std::function<void()>& second) {
    if (threads == 1) {
        first();
        second();
    } else {
        const std::function<bool()>* ended = WorkWatch::for_helpers();
        oneapi::tbb::parallel_invoke([&] { help(ended, first); }, [&] { help(ended, second); });
    }
}

}  // namespace candelabra
