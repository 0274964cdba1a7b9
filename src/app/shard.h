// SPDX-License-Identifier: GPL-3.0-or-later
// One run's part of work that several do: --shard 2/4, or what the variables of job arrays say.
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

/// The value of a variable of the environment, or nothing.
using Environment = std::function<std::optional<std::string>(const std::string&)>;

/// What --shard says: `2/4`, or `auto` and `auto/4`, which ask Slurm's, AWS Batch's and
/// Kubernetes' variables for the number and, where they know it, the count. Nothing after a
/// report.
std::optional<Shard> read_shard(const std::string& text, const Environment&, Diagnostics&);

/// "2of4"
std::string shard_name(const Shard&);

/// First of the things 0 ... all - 1 that belong to a shard; that of the next shard ends them.
/// Shares differ by one at most.
std::uint32_t first_of(const Shard&, std::uint32_t all);

}  // namespace candelabra
