// SPDX-License-Identifier: GPL-3.0-or-later
// The signals that ask a rendering to stop (SIGINT, SIGTERM, SIGHUP) or to write its state
// (SIGUSR1), taken by a thread of their own, so that no handler and no global is needed. While
// nothing listens, the first three end the program as they always do, and SIGUSR1 is let go. Made
// first thing in main(): threads that exist already would not leave the signals to it.
#pragma once

#include "app/interrupt.h"

#include <atomic>
#include <csignal>
#include <thread>

namespace candelabra {

class Signals {
public:
    Signals();
    Signals(const Signals&) = delete;
    Signals& operator=(const Signals&) = delete;
    ~Signals();

    Interrupts interrupts();

private:
    void wait();
    void arrived(int signal);

    sigset_t taken_;
    std::atomic<Interrupt> asked_ = Interrupt::none;
    std::atomic<bool> listening_ = false;
    std::atomic<bool> ending_ = false;
    std::thread thread_;
};

}  // namespace candelabra
