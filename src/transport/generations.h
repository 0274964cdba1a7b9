// SPDX-License-Identifier: GPL-3.0-or-later
// Light that is sent from lamps before paths come from the camera, in independent generations: each
// serves some samples of all pixels. A generation is a pure function of its number, and is made
// when it is first asked for; any number of threads may ask.
#pragma once

#include "base/function_ref.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>

namespace candelabra {

template <class Made>
class Generations {
public:
    /// So many are kept in memory; others are made again when they are asked for.
    explicit Generations(std::size_t kept) : kept_(kept) {}

    std::shared_ptr<const Made> get(std::uint32_t number, FunctionRef<Made()> make) {
        std::shared_ptr<Entry> entry;
        {
            const std::lock_guard lock(mutex_);
            std::shared_ptr<Entry>& place = entries_[number];
            if (!place) place = std::make_shared<Entry>();
            entry = place;
            // Those that were asked for long ago have the lowest numbers.
            if (entries_.size() > kept_)
                entries_.erase(entries_.begin()->first == number ? std::next(entries_.begin())
                                                                 : entries_.begin());
        }
        const std::lock_guard lock(entry->making);
        if (!entry->made) entry->made = std::make_shared<const Made>(make());
        return entry->made;
    }

private:
    struct Entry {
        std::mutex making;
        std::shared_ptr<const Made> made;
    };

    std::size_t kept_;
    std::mutex mutex_;
    std::map<std::uint32_t, std::shared_ptr<Entry>> entries_;
};

}  // namespace candelabra
