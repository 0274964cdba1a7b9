// SPDX-License-Identifier: GPL-3.0-or-later
// Signals arrive at the thread that has started the worker; it leaves them in a word that both
// share (src/packaging/npm/lib/worker.mjs).
#include "console/signals.h"

extern "C" {
/// Returns what the signals have asked for since the last call: 0 nothing, 1 to save, 2 to stop.
int candelabra_interrupt();
/// Says whether signals are listened to; while they are not, they end the program as usual.
void candelabra_listens(int on);
}

namespace candelabra {

struct Signals::Waiter {};

Signals::Signals() = default;
Signals::~Signals() = default;

Interrupts Signals::interrupts() {
    return {
        [] {
            const int asked = candelabra_interrupt();
            return asked == 2 ? Interrupt::stop : asked == 1 ? Interrupt::save : Interrupt::none;
        },
        [](bool on) { candelabra_listens(on ? 1 : 0); }};
}

}  // namespace candelabra
