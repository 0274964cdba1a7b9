// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the work that one of several runs does: --shard 2/4, or the variables of job arrays.
#pragma once

#include "text/diagnostic.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace candelabra {

inline constexpr int max_shards = 1'000'000;

enum class ShardBy { samples, tiles, frames };

struct Shard {
    int number = 1;  ///< from 1
    int count = 1;
    friend bool operator==(const Shard&, const Shard&) = default;
};

/// Returns the value of an environment variable, or nothing.
using Environment = std::function<std::optional<std::string>(const std::string&)>;

/// Parses the value of --shard: `2/4`, or `auto` and `auto/4`, which take the number and, where
/// available, the count from the variables of Slurm, AWS Batch and Kubernetes. Returns nothing
/// after an error has been reported.
std::optional<Shard> read_shard(const std::string& text, const Environment&, Diagnostics&);

/// "2of4"
std::string shard_name(const Shard&);

/// Returns the first of the items 0 ... all - 1 that belong to a shard, which ends at the first
/// item of the next. Sizes of shards differ by at most one.
std::uint32_t first_of(const Shard&, std::uint32_t all);

}  // namespace candelabra
