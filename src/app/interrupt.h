// SPDX-License-Identifier: GPL-3.0-or-later
// What a rendering is asked from outside while it works. Signals become this (app/signals.h); tests
// make it up.
#pragma once

#include <functional>

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
