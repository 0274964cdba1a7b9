// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/signals.h"

#include <csignal>

#include <pthread.h>
#include <unistd.h>

namespace {

sigset_t set_of(std::initializer_list<int> signals) {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : signals) sigaddset(&set, signal);
    return set;
}

sigset_t taken() { return set_of({SIGINT, SIGTERM, SIGUSR1}); }

}  // namespace

Signals::Signals() {
    const sigset_t set = taken();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    // A full disk or a closed pipe is an error of writing, which has its own message.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    thread_ = std::thread([this] { wait(); });
}

Signals::~Signals() {
    ending_ = true;
    pthread_kill(thread_.native_handle(), SIGUSR1);
    thread_.join();
    const sigset_t set = taken();
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

void Signals::wait() {
    const sigset_t set = taken();
    while (!ending_) {
        int signal = 0;
        if (sigwait(&set, &signal) == 0 && !ending_) arrived(signal);
    }
}

void Signals::arrived(int signal) {
    if (signal == SIGUSR1) {
        Interrupt none = Interrupt::none;
        if (listening_) asked_.compare_exchange_strong(none, Interrupt::save);
        return;
    }
    if (listening_ && asked_.exchange(Interrupt::stop) != Interrupt::stop) return;
    // Nobody listens, or somebody cannot wait: as if this thread were not there.
    std::signal(signal, SIG_DFL);
    const sigset_t set = set_of({signal});
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
    kill(getpid(), signal);
}

Interrupts Signals::interrupts() {
    return {[this] {
                // A load is all that it costs most of the time.
                return asked_ == Interrupt::none ? Interrupt::none
                                                 : asked_.exchange(Interrupt::none);
            },
            [this](bool on) { listening_ = on; }};
}
