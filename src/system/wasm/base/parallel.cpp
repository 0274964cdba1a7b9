// SPDX-License-Identifier: GPL-3.0-or-later
// One thread: WebAssembly shares memory only where a page's server sends special headers.
#include "base/parallel.h"

namespace candelabra {

int core_count() { return 1; }

void run_on_threads(int, const std::function<void()>& work) { work(); }

void run_parallel(std::size_t count, int, const std::function<void(std::size_t)>& job) {
    for (std::size_t i = 0; i < count; ++i) job(i);
}

void run_both(int, const std::function<void()>& first, const std::function<void()>& second) {
    first();
    second();
}

}  // namespace candelabra
