// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/deep_stack.h"

#include <pthread.h>

namespace {

struct Job {
    FunctionRef<void(std::size_t)> function;
    std::size_t bytes;
};

bool run(Job& job) {
    pthread_attr_t attributes;
    pthread_t thread;
    if (pthread_attr_init(&attributes) != 0) return false;
    const auto entry = [](void* argument) -> void* {
        Job& job = *static_cast<Job*>(argument);
        job.function(job.bytes);
        return nullptr;
    };
    const bool started = pthread_attr_setstacksize(&attributes, job.bytes) == 0 &&
                         pthread_create(&thread, &attributes, entry, &job) == 0;
    pthread_attr_destroy(&attributes);
    if (started) pthread_join(thread, nullptr);
    return started;
}

}  // namespace

void on_deep_stack(std::size_t bytes, FunctionRef<void(std::size_t)> function) {
    constexpr std::size_t least = std::size_t{4} << 20;
    for (; bytes > least; bytes /= 2) {
        Job job{function, bytes};
        if (run(job)) return;
    }
    function(least);  // here: systems give the first thread at least this
}
