// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/limit_options.h"

#include "app/option_table.h"
#include "app/read_words.h"

#include <string>

namespace candelabra {

TEST_CASE("each limit has its option, and bounds", "[app]") {
    const Limits limits = read({"--limit-steps=11", "--limit-depth=12", "--limit-nesting=13",
                                "--limit-objects=14", "--limit-includes=15", "--limit-files=16",
                                "--limit-elements=17", "--limit-written=18", "--limit-said=19",
                                "--limit-text=20", "--limit-function=21", "--limit-work=22"})
                              .limits;
    CHECK(limits.steps == 11);
    CHECK(limits.call_depth == 12);
    CHECK(limits.nesting == 13);
    CHECK(limits.objects == 14);
    CHECK(limits.include_depth == 15);
    CHECK(limits.files == 16);
    CHECK(limits.array_elements == 17);
    CHECK(limits.written_bytes == 18u << 20);
    CHECK(limits.said_bytes == 19u << 20);
    CHECK(limits.text_bytes == 20u << 20);
    CHECK(limits.function_steps == 21);
    CHECK(limits.work == 22'000'000);
    for (const OptionRow& row : option_table()) {
        if (!row.word.starts_with("limit-")) continue;
        for (const char* value : {"0", "-1", "1e13", "1e300", "inf", "nan", "1.5", "x", "0x10"}) {
            const std::string option = "--" + std::string(row.word) + "=" + value;
            read({option}, false);
        }
    }
    read({"--limit-depth=1e12"}, false);
    read({"--limit-nesting=1e9"}, false);
}

TEST_CASE("a limit is within others when none of its kinds is higher", "[app]") {
    const Limits usual;
    CHECK(usual.within(usual));
    const auto higher = [&](auto member) {
        Limits limits;
        ++(limits.*member);
        return !limits.within(usual) && usual.within(limits);
    };
    CHECK(higher(&Limits::call_depth));
    CHECK(higher(&Limits::nesting));
    CHECK(higher(&Limits::include_depth));
    CHECK(higher(&Limits::steps));
    CHECK(higher(&Limits::array_elements));
    CHECK(higher(&Limits::objects));
    CHECK(higher(&Limits::written_bytes));
    CHECK(higher(&Limits::files));
    CHECK(higher(&Limits::said_bytes));
    CHECK(higher(&Limits::text_bytes));
    CHECK(higher(&Limits::function_steps));
    CHECK(higher(&Limits::work));
    CHECK(higher(&Limits::stack_bytes));
}

TEST_CASE("limits are raised with the stack that they need") {
    Options options;
    Diagnostics diagnostics;
    const std::size_t usual = options.limits.stack_bytes;
    store::limit_nesting(options, {"--limit-nesting", true, "20000"}, diagnostics);
    CHECK(options.limits.nesting == 20'000);
    store::limit_nesting(options, {"--limit-nesting", true, "1e6"}, diagnostics);
    CHECK(options.limits.nesting == 1'000'000);
    CHECK(options.limits.stack_bytes > usual);
    store::limit_depth(options, {"--limit-depth", true, "1e7"}, diagnostics);
    CHECK(options.limits.call_depth == 10'000'000);
    CHECK(options.limits.stack_bytes > 10 * usual);
    store::limit_includes(options, {"--limit-includes", true, "1000"}, diagnostics);
    CHECK(options.limits.include_depth == 1000);
    store::limit_objects(options, {"--limit-objects", true, "1e8"}, diagnostics);
    CHECK(options.limits.objects == 100'000'000);
    store::limit_elements(options, {"--limit-elements", true, "5"}, diagnostics);
    CHECK(options.limits.array_elements == 5);
    store::limit_elements(options, {"--limit-elements", true, "1e12"}, diagnostics);
    CHECK(options.limits.array_elements == 2'000'000'000);
    store::limit_steps(options, {"--limit-steps", true, "0"}, diagnostics);
    CHECK(options.limits.steps == Limits().steps);
    CHECK(diagnostics.error_count() == 1);
}

}  // namespace candelabra
