// SPDX-License-Identifier: GPL-3.0-or-later
#include "console/signals.h"

#include <csignal>
#include <initializer_list>

#include <pthread.h>
#include <unistd.h>

namespace candelabra {

namespace {

sigset_t set_of(std::initializer_list<int> signals) {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : signals) sigaddset(&set, signal);
    return set;
}

/// Returns the signals to receive. SIGHUP stays ignored if it was, as nohup requires.
sigset_t taken() {
    struct sigaction hangup {};
    sigaction(SIGHUP, nullptr, &hangup);
    return hangup.sa_handler == SIG_IGN ? set_of({SIGINT, SIGTERM, SIGUSR1})
                                        : set_of({SIGINT, SIGTERM, SIGUSR1, SIGHUP});
}

}  // namespace

Signals::Signals() : taken_(taken()) {
    pthread_sigmask(SIG_BLOCK, &taken_, nullptr);
    // A full disk or a closed pipe is reported as a write error.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    thread_ = std::thread([this] { wait(); });
}

Signals::~Signals() {
    ending_ = true;
    pthread_kill(thread_.native_handle(), SIGUSR1);
    thread_.join();
    pthread_sigmask(SIG_UNBLOCK, &taken_, nullptr);
}

void Signals::wait() {
    while (!ending_) {
        int signal = 0;
        if (sigwait(&taken_, &signal) == 0 && !ending_) arrived(signal);
    }
}

void Signals::arrived(int signal) {
    if (signal == SIGUSR1) {
        Interrupt none = Interrupt::none;
        if (listening_) asked_.compare_exchange_strong(none, Interrupt::save);
        return;
    }
    if (listening_ && asked_.exchange(Interrupt::stop) != Interrupt::stop) return;
    // Applies the default action, since nothing listens or the user insists.
    std::signal(signal, SIG_DFL);
    const sigset_t set = set_of({signal});
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
    kill(getpid(), signal);
}

Interrupts Signals::interrupts() {
    return {[this] {
                // Usually costs only a load.
                return asked_ == Interrupt::none ? Interrupt::none
                                                 : asked_.exchange(Interrupt::none);
            },
            [this](bool on) { listening_ = on; }};
}

}  // namespace candelabra
