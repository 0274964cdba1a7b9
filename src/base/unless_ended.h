// SPDX-License-Identifier: GPL-3.0-or-later
// Work of all threads that somebody may end, with its result if it is finished.
#pragma once

#include "base/work_watch.h"

#include <functional>
#include <optional>

namespace candelabra {

/// Returns work(); nothing if `ended`, which several threads ask, says so before it is finished. If
/// `ended` is empty, the work is ended as that around it.
template <class Work>
auto unless_ended(const std::function<bool()>& ended, const Work& work)
    -> std::optional<decltype(work())> {
    if (!ended) return work();
    try {
        const WorkWatch watch(ended, WorkWatch::Asks::everywhere);
        return work();
    } catch (const WorkEnded&) {
        return std::nullopt;
    }
}

}  // namespace candelabra
