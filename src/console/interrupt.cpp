// SPDX-License-Identifier: GPL-3.0-or-later
#include "console/interrupt.h"

#include <memory>

namespace candelabra {

Interrupts SharedInterrupts::for_one() {
    Interrupts one;
    if (asked_.take)
        one.take = [this, heard = std::make_shared<std::atomic<int>>(saves_.load())] {
            return take(*heard);
        };
    if (asked_.listening) one.listening = [this](bool on) { listen(on); };
    return one;
}

Interrupt SharedInterrupts::take(std::atomic<int>& heard) {
    const Interrupt now = asked_.take();
    if (now == Interrupt::stop) stopped_ = true;
    if (now == Interrupt::save) ++saves_;
    if (stopped_) return Interrupt::stop;
    const int saves = saves_;
    return heard.exchange(saves) != saves ? Interrupt::save : Interrupt::none;
}

void SharedInterrupts::listen(bool on) {
    const std::lock_guard lock(mutex_);
    listeners_ += on ? 1 : -1;
    asked_.listening(listeners_ > 0);
}

}  // namespace candelabra
