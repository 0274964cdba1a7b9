// SPDX-License-Identifier: GPL-3.0-or-later
// Ends work that lasts too long where it cannot be divided, such as a ray between mirrors or the
// value of a slow function. Such work counts its steps. Where somebody may want it to end, a
// WorkWatch is kept on the thread, and asks whether to go on after some ten thousand steps.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <utility>

namespace candelabra {

/// Thrown by count_work() where the work is to end. What it has begun is lost.
struct WorkEnded {};

/// Asks on its thread, while it exists, whether work is to end. Watches may be nested: the
/// innermost one counts.
class WorkWatch {
public:
    /// Where it is asked: `everywhere` is also on threads that run_parallel() and run_both() give
    /// parts of the work to.
    enum class Asks { on_this_thread, everywhere };

    /// `ended` may be empty: then nothing is asked. It is called some hundred times a second.
    explicit WorkWatch(const std::function<bool()>& ended, Asks asks = Asks::on_this_thread)
        : before_(std::exchange(state(), State{ended ? &ended : nullptr, interval, 0, asks})) {}
    WorkWatch(const WorkWatch&) = delete;
    WorkWatch& operator=(const WorkWatch&) = delete;
    ~WorkWatch() { state() = before_; }

    /// Number of steps since it exists. Precondition: it is the innermost one, and not empty.
    std::uint64_t counted() const {
        const State& here = state();
        return static_cast<std::uint64_t>((here.asked + 1) * interval - here.left);
    }

    /// What helping threads ask for this one; null: nothing.
    static const std::function<bool()>* for_helpers() {
        const State& here = state();
        return here.asks == Asks::everywhere ? here.ended : nullptr;
    }

private:
    friend void count_work(std::uint32_t);

    /// Number of steps between two questions. A step takes some 20 to 500 ns.
    static constexpr std::int64_t interval = 20'000;

    struct State {
        const std::function<bool()>* ended = nullptr;
        std::int64_t left = std::numeric_limits<std::int64_t>::max();
        std::int64_t asked = 0;
        Asks asks = Asks::on_this_thread;
    };
    /// The watch of this thread. Functions of numbers, shapes and patterns are called through many
    /// layers that do not know of it, so it is no parameter. It never changes a result.
    static State& state() {
        thread_local constinit State here;
        return here;
    }
    static void ask() {
        State& here = state();
        if (!here.ended) {
            here.left = std::numeric_limits<std::int64_t>::max();
            return;
        }
        const std::int64_t times = 1 - here.left / interval;
        here.left += times * interval;
        here.asked += times;
        if ((*here.ended)()) throw WorkEnded();
    }

    State before_;
};

/// Counts steps of work, each of the length of some arithmetic. Throws WorkEnded if this thread's
/// WorkWatch finds that work is to end.
inline void count_work(std::uint32_t steps) {
    WorkWatch::State& here = WorkWatch::state();
    here.left -= steps;
    if (here.left < 0) [[unlikely]]
        WorkWatch::ask();
}

}  // namespace candelabra
