// SPDX-License-Identifier: GPL-3.0-or-later
#include "console/signals.h"

#include <atomic>
#include <csignal>
#include <initializer_list>
#include <thread>

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

struct Signals::Waiter {
    sigset_t taken = candelabra::taken();
    std::atomic<Interrupt> asked = Interrupt::none;
    std::atomic<bool> listening = false;
    std::atomic<bool> ending = false;
    std::thread thread = {};

    void wait();
    void arrived(int signal);
};

Signals::Signals() : waiter_(std::make_unique<Waiter>()) {
    pthread_sigmask(SIG_BLOCK, &waiter_->taken, nullptr);
    // A full disk or a closed pipe is reported as a write error.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    waiter_->thread = std::thread([waiter = waiter_.get()] { waiter->wait(); });
}

Signals::~Signals() {
    waiter_->ending = true;
    pthread_kill(waiter_->thread.native_handle(), SIGUSR1);
    waiter_->thread.join();
    pthread_sigmask(SIG_UNBLOCK, &waiter_->taken, nullptr);
}

void Signals::Waiter::wait() {
    while (!ending) {
        int signal = 0;
        if (sigwait(&taken, &signal) == 0 && !ending) arrived(signal);
    }
}

void Signals::Waiter::arrived(int signal) {
    if (signal == SIGUSR1) {
        Interrupt none = Interrupt::none;
        if (listening) asked.compare_exchange_strong(none, Interrupt::save);
        return;
    }
    if (listening && asked.exchange(Interrupt::stop) != Interrupt::stop) return;
    // Applies the default action, since nothing listens or the user insists.
    std::signal(signal, SIG_DFL);
    const sigset_t set = set_of({signal});
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
    kill(getpid(), signal);
}

Interrupts Signals::interrupts() {
    return {[waiter = waiter_.get()] {
                // Usually costs only a load.
                return waiter->asked == Interrupt::none ? Interrupt::none
                                                        : waiter->asked.exchange(Interrupt::none);
            },
            [waiter = waiter_.get()](bool on) { waiter->listening = on; }};
}

}  // namespace candelabra
