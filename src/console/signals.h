// SPDX-License-Identifier: GPL-3.0-or-later
// Receives the signals that ask a rendering to stop (SIGINT, SIGTERM, SIGHUP) or to write its state
// (SIGUSR1) on a thread of its own, so that no handler and no global is needed. While nothing
// listens, the first three end the program as usual, and SIGUSR1 is ignored. Construct it first in
// main(), since threads that already exist would not block these signals.
#pragma once

#include "console/interrupt.h"

#include <memory>

namespace candelabra {

class Signals {
public:
    Signals();
    Signals(const Signals&) = delete;
    Signals& operator=(const Signals&) = delete;
    ~Signals();

    Interrupts interrupts();

private:
    struct Waiter;
    std::unique_ptr<Waiter> waiter_;
};

}  // namespace candelabra
