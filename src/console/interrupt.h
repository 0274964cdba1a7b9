// SPDX-License-Identifier: GPL-3.0-or-later
// Requests from outside to a rendering in progress. They come from signals (console/signals.h) or
// from tests.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <utility>

namespace candelabra {

enum class Interrupt {
    none,
    save,  ///< write the state and continue
    stop,  ///< write the state and end
};

/// The source of requests. Both functions may be empty.
struct Interrupts {
    std::function<Interrupt()> take;      ///< request since the last call; any thread
    std::function<void(bool)> listening;  ///< announces whether take() will be called soon
};

/// Passes each request to several renderings at a time, and a stop also to renderings that begin
/// later.
class SharedInterrupts {
public:
    explicit SharedInterrupts(Interrupts asked) : asked_(std::move(asked)) {}

    /// Returns the requests for one rendering. Valid for the lifetime of this object.
    Interrupts for_one();

private:
    /// `heard`: the number of requests to save that this rendering has received.
    Interrupt take(std::atomic<int>& heard);
    void listen(bool on);

    Interrupts asked_;
    std::atomic<bool> stopped_ = false;
    std::atomic<int> saves_ = 0;
    std::mutex mutex_;
    int listeners_ = 0;
};

}  // namespace candelabra
