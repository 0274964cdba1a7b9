// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/shard.h"

#include "text/message.h"
#include "text/printable.h"

#include <array>
#include <charconv>
#include <system_error>

namespace candelabra {

namespace {

std::optional<int> whole(const std::optional<std::string>& text) {
    if (!text || text->empty()) return std::nullopt;
    int value = 0;
    const auto [end, failed] = std::from_chars(text->data(), text->data() + text->size(), value);
    const bool good = failed == std::errc() && end == text->data() + text->size();
    return good && value >= 0 && value <= max_shards ? std::optional(value) : std::nullopt;
}

/// Environment variables that a queueing system sets for each job of an array.
struct Engine {
    const char* index;
    const char* first;  ///< the first index; null: 0
    const char* step;
    const char* count;
};
constexpr auto engines = std::array{
    Engine{"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_STEP",
           "SLURM_ARRAY_TASK_COUNT"},
    Engine{"AWS_BATCH_JOB_ARRAY_INDEX", nullptr, nullptr, "AWS_BATCH_JOB_ARRAY_SIZE"},
    Engine{"JOB_COMPLETION_INDEX", nullptr, nullptr, nullptr},
};

/// Returns the shard's number and count; the count is 0 if unknown.
std::optional<Shard> from_environment(const Environment& variable) {
    const auto value = [&](const char* name, int otherwise) {
        return name ? whole(variable(name)).value_or(otherwise) : otherwise;
    };
    for (const Engine& engine : engines)
        if (const auto index = variable ? whole(variable(engine.index)) : std::nullopt) {
            const int step = std::max(1, value(engine.step, 1));
            return Shard{(*index - value(engine.first, 0)) / step + 1, value(engine.count, 0)};
        }
    return std::nullopt;
}

}  // namespace

std::optional<Shard> read_shard(const std::string& text, const Environment& variable,
                                Diagnostics& diagnostics) {
    const auto refuse = [&](std::string_view rule, std::string help) {
        diagnostics.add(error(Fault::option, {}, message("`--shard ", printable(text), "`: ", rule))
                            .with_help(std::move(help)));
        return std::nullopt;
    };
    const std::size_t slash = std::min(text.find('/'), text.size());
    Shard shard;
    if (text.substr(0, slash) == "auto") {
        const auto found = from_environment(variable);
        if (!found)
            return refuse("no job array has set its variables",
                          "SLURM_ARRAY_TASK_ID, AWS_BATCH_JOB_ARRAY_INDEX or JOB_COMPLETION_INDEX");
        shard = *found;
        if (slash == text.size() && shard.count == 0)
            return refuse("the number of jobs in the job array is unknown", "--shard auto/N");
    } else {
        shard.number = whole(text.substr(0, slash)).value_or(0);
        shard.count = 0;
    }
    if (slash < text.size()) shard.count = whole(text.substr(slash + 1)).value_or(0);
    if (shard.number < 1 || shard.count < 1 || shard.number > shard.count)
        return refuse("a shard is a number from 1 on and how many there are, as in 2/4", {});
    return shard;
}

std::string shard_name(const Shard& shard) { return message(shard.number, "of", shard.count); }

std::uint32_t first_of(const Shard& shard, std::uint32_t all) {
    return static_cast<std::uint32_t>(std::uint64_t{all} *
                                      static_cast<std::uint64_t>(shard.number - 1) /
                                      static_cast<std::uint64_t>(shard.count));
}

}  // namespace candelabra
