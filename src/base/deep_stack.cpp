// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/deep_stack.h"

#include <exception>

#include <pthread.h>
#include <sys/mman.h>
#include <unistd.h>

namespace candelabra {

namespace {

struct Job {
    FunctionRef<void(std::size_t)> function;
    std::size_t bytes;
    std::exception_ptr thrown = {};
};

/// Remaining stack of this thread in bytes; 0 for the main thread.
std::size_t room() {
    pthread_attr_t attributes;
    if (getpid() == gettid() || pthread_getattr_np(pthread_self(), &attributes) != 0) return 0;
    void* lowest = nullptr;
    std::size_t bytes = 0;
    const bool known = pthread_attr_getstack(&attributes, &lowest, &bytes) == 0;
    pthread_attr_destroy(&attributes);
    const char here = 0;
    return known ? static_cast<std::size_t>(&here - static_cast<char*>(lowest)) : 0;
}

/// The first part of a stack, which all scenes use.
constexpr std::size_t usual = std::size_t{1} << 20;
constexpr std::size_t guard = std::size_t{1} << 16;

bool start(Job& job, char* lowest, pthread_t& thread) {
    const auto entry = [](void* argument) -> void* {
        Job& job = *static_cast<Job*>(argument);
        try {
            job.function(job.bytes);
        } catch (...) {
            job.thrown = std::current_exception();
        }
        return nullptr;
    };
    pthread_attr_t attributes;
    if (pthread_attr_init(&attributes) != 0) return false;
    const bool started = pthread_attr_setstack(&attributes, lowest, job.bytes) == 0 &&
                         pthread_create(&thread, &attributes, entry, &job) == 0;
    pthread_attr_destroy(&attributes);
    return started;
}

bool run(Job& job) {
    void* const stack = mmap(nullptr, job.bytes + guard, PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS | MAP_STACK | MAP_NORESERVE, -1, 0);
    if (stack == MAP_FAILED) return false;
    mprotect(stack, guard, PROT_NONE);
    char* const lowest = static_cast<char*>(stack) + guard;
    // Otherwise a deep recursion would wait for each small page.
    madvise(lowest, job.bytes - usual, MADV_HUGEPAGE);
    pthread_t thread;
    const bool started = start(job, lowest, thread);
    if (started) pthread_join(thread, nullptr);
    munmap(stack, job.bytes + guard);
    return started;
}

}  // namespace

void on_deep_stack(std::size_t bytes, FunctionRef<void(std::size_t)> function) {
    if (const std::size_t left = room(); left >= bytes / 2) return function(left);
    constexpr std::size_t least = std::size_t{4} << 20;
    for (; bytes > least; bytes /= 2) {
        Job job{function, bytes};
        if (!run(job)) continue;
        if (job.thrown) std::rethrow_exception(job.thrown);
        return;
    }
    function(least);  // here: systems give the main thread at least this
}

std::uint64_t memory_of_deep_stack(std::size_t bytes) { return bytes; }

}  // namespace candelabra
