// SPDX-License-Identifier: GPL-3.0-or-later
// Light sent from lamps before paths start at the camera, in independent generations: each serves
// some samples of all pixels. A generation is a pure function of its number, and is made on the
// first request; any number of threads may request one.
#pragma once

#include "base/function_ref.h"
#include "base/parallel.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace candelabra {

/// Returns all that `send(first, last, found)` adds to `found` for the light paths from `first` to
/// before `last`, out of `count`, in their order. One thread follows `at_once` paths at a time.
template <class Found>
std::vector<Found> sent_in_batches(
    std::uint32_t count, std::uint32_t at_once, int threads,
    FunctionRef<void(std::uint32_t, std::uint32_t, std::vector<Found>&)> send) {
    std::vector<std::vector<Found>> parts((count + at_once - 1) / at_once);
    run_parallel(parts.size(), threads, [&](std::size_t part) {
        const auto first = static_cast<std::uint32_t>(part) * at_once;
        send(first, std::min(first + at_once, count), parts[part]);
    });
    std::vector<Found> all;
    for (const std::vector<Found>& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

/// Returns the number of the generation that serves a sample. Each of the first `single` samples
/// has its own, so that pictures of few samples are averages of several. Then one serves `shared`
/// samples, so that sending takes a small part of the time.
constexpr std::uint32_t generation_serving(std::uint32_t sample, std::uint32_t single,
                                           std::uint32_t shared) {
    return sample < single ? sample : single + (sample - single) / shared;
}

template <class Made>
class Generations {
public:
    /// Keeps `kept` generations in memory; others are made again on request.
    explicit Generations(std::size_t kept) : kept_(kept) {}

    std::shared_ptr<const Made> get(std::uint32_t number, FunctionRef<Made()> make) {
        std::shared_ptr<Entry> entry;
        {
            const std::lock_guard lock(mutex_);
            std::shared_ptr<Entry>& place = entries_[number];
            if (!place) place = std::make_shared<Entry>();
            entry = place;
            // The generations used longest ago have the lowest numbers.
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

/// One job's view of the generations of a source, of which it keeps the last that it used. Null if
/// it has no source.
template <class Source>
class ServedGeneration {
public:
    ServedGeneration() = default;
    explicit ServedGeneration(std::shared_ptr<Source> source) : source_(std::move(source)) {}

    explicit operator bool() const { return source_ != nullptr; }
    const Source& source() const { return *source_; }

    /// Returns the generation that serves that sample of a pixel, until the next call. Null if
    /// there is no source.
    auto* begin(std::uint32_t sample) {
        const std::uint32_t wanted = number_of(sample);
        if (source_ && (!made_ || number_ != wanted)) {
            made_ = source_->generation(wanted);
            number_ = wanted;
        }
        return made_.get();
    }
    /// The same generation again. Precondition: begin() was called, and there is a source.
    const auto& current() const { return *made_; }

    /// Builds the generation for a sample, with all threads.
    void prepare(std::uint32_t sample) const {
        if (source_) source_->generation(number_of(sample));
    }

private:
    static std::uint32_t number_of(std::uint32_t sample) {
        return generation_serving(sample, Source::single_samples, Source::shared_samples);
    }

    std::shared_ptr<Source> source_;
    decltype(std::declval<Source&>().generation(0)) made_;
    std::uint32_t number_ = 0;  ///< of made_
};

}  // namespace candelabra
