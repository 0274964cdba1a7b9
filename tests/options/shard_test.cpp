// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/shard.h"

#include <catch2/catch.hpp>

#include <map>

namespace candelabra {

TEST_CASE("a shard is given, or comes from a job array") {
    using Variables = std::map<std::string, std::string>;
    struct Case {
        const char* text;
        Variables variables;
        std::optional<Shard> expected;
    };
    const Variables slurm = {{"SLURM_ARRAY_TASK_ID", "6"},
                             {"SLURM_ARRAY_TASK_MIN", "2"},
                             {"SLURM_ARRAY_TASK_STEP", "2"},
                             {"SLURM_ARRAY_TASK_COUNT", "5"}};
    const Variables batch = {{"AWS_BATCH_JOB_ARRAY_INDEX", "0"}, {"AWS_BATCH_JOB_ARRAY_SIZE", "3"}};
    const Variables kubernetes = {{"JOB_COMPLETION_INDEX", "3"}};
    const Case cases[] = {
        {"1/1", {}, Shard{1, 1}},
        {"2/4", {}, Shard{2, 4}},
        {"auto", slurm, Shard{3, 5}},
        {"auto", batch, Shard{1, 3}},
        {"auto/4", kubernetes, Shard{4, 4}},
        {"auto/8", slurm, Shard{3, 8}},
        {"auto", kubernetes, {}},
        {"auto", {}, {}},
        {"auto/3", kubernetes, {}},
        {"0/4", {}, {}},
        {"5/4", {}, {}},
        {"2", {}, {}},
        {"", {}, {}},
        {"/", {}, {}},
        {"2/", {}, {}},
        {"2/4x", {}, {}},
        {"-1/4", {}, {}},
        {"1/99999999999", {}, {}},
    };
    for (const Case& each : cases) {
        CAPTURE(each.text);
        Diagnostics diagnostics;
        const Environment environment = [&](const std::string& name) {
            const auto found = each.variables.find(name);
            return found == each.variables.end() ? std::nullopt : std::optional(found->second);
        };
        CHECK(read_shard(each.text, environment, diagnostics) == each.expected);
        CHECK(diagnostics.failed() == !each.expected);
    }
}

TEST_CASE("shards are as equal as can be and leave nothing out") {
    for (const std::uint32_t all : {1u, 7u, 16u, 1000001u})
        for (const int count : {1, 3, 7}) {
            CHECK(first_of({1, count}, all) == 0);
            CHECK(first_of({count + 1, count}, all) == all);
            for (int i = 1; i <= count; ++i) {
                const auto size = first_of({i + 1, count}, all) - first_of({i, count}, all);
                CHECK((size == all / count || size == all / count + 1));
            }
        }
}

}  // namespace candelabra
