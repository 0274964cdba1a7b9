// SPDX-License-Identifier: GPL-3.0-or-later
// What renderings are asked from outside while they work. Signals become this (app/signals.h);
// tests make it up.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <utility>

namespace candelabra {

enum class Interrupt {
    none,
    save,  ///< write the state and go on
    stop,  ///< write the state and end
};

/// Whoever can ask. Both may be empty.
struct Interrupts {
    std::function<Interrupt()> take;      ///< what was asked since the last call; any thread
    std::function<void(bool)> listening;  ///< whether somebody will soon call take()
};

/// For several renderings at a time: what is asked, all of them are asked, also those that begin
/// after a stop.
class SharedInterrupts {
public:
    explicit SharedInterrupts(Interrupts asked) : asked_(std::move(asked)) {}

    /// For one of them. Valid as long as this is.
    Interrupts for_one();

private:
    /// `heard`: how many times this one has been asked to save.
    Interrupt take(std::atomic<int>& heard);
    void listen(bool on);

    Interrupts asked_;
    std::atomic<bool> stopped_ = false;
    std::atomic<int> saves_ = 0;
    std::mutex mutex_;
    int listeners_ = 0;
};

}  // namespace candelabra
