// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/option_field.h"

#include "options/option_table.h"
#include "options/read_words.h"

#include <string>

namespace candelabra {

TEST_CASE("times and sizes have units") {
    CHECK(read({"--time", "90"}).time == 90.0);
    CHECK(read({"--time", "1.5m"}).time == 90.0);
    CHECK(read({"--checkpoint=2H"}).checkpoint_interval == 7200);
    CHECK(read({"--checkpoint=0"}).checkpoint_interval == 0);
    CHECK(read({"--memory", "8G"}).memory_bytes == std::uint64_t{8} << 30);
    CHECK(read({"--memory", "500m"}).memory_bytes == std::uint64_t{500} << 20);
    for (const char* bad : {"--time=x", "--time=-1", "--time=s", "--time=0", "--memory=1",
                            "--memory=8Q", "--checkpoint=1d", "--shard-by=rows", "+SR-1", "+EC"})
        read({bad}, false);
}

TEST_CASE("parts of a picture are numbers or fractions; states and shards are switched on") {
    const Options options = read({"+SR3", "End_Row=0.5", "+SC1", "+EC20", "+C", "--keep-state",
                                  "--shard", "2/4", "--shard-by", "tiles", "--noise", "0.02"});
    CHECK(options.start_row == 3.0);
    CHECK(options.end_row == 0.5);
    CHECK(options.end_column == 20.0);
    CHECK(options.go_on);
    CHECK(options.keep_state);
    CHECK(options.shard == "2/4");
    CHECK(options.shard_by == ShardBy::tiles);
    CHECK(options.render.noise == 0.02);
}

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
    const std::size_t usual = Limits().stack_bytes;
    CHECK(read({"--limit-nesting=20000"}).limits.nesting == 20'000);
    const Limits deep = read({"--limit-nesting=1e6", "--limit-depth=1e7"}).limits;
    CHECK(deep.nesting == 1'000'000);
    CHECK(deep.call_depth == 10'000'000);
    CHECK(read({"--limit-nesting=1e6"}).limits.stack_bytes > usual);
    CHECK(deep.stack_bytes > 10 * usual);
    CHECK(read({"--limit-includes=1000"}).limits.include_depth == 1000);
    CHECK(read({"--limit-objects=1e8"}).limits.objects == 100'000'000);
    CHECK(read({"--limit-elements=5"}).limits.array_elements == 5);
    CHECK(read({"--limit-elements=1e12"}).limits.array_elements == 2'000'000'000);
    CHECK(read({"--limit-steps=0"}, false).limits.steps == Limits().steps);
    CHECK(read({"--limit-memory=2"}).memory_bytes == 2u << 20);
}

namespace {

std::string answer_to(std::string_view word) {
    Diagnostics diagnostics;
    read_options(std::vector<std::string_view>{word}, diagnostics);
    std::string text;
    for (const Diagnostic& each : diagnostics.all()) text += each.message + " | " + each.help;
    return text;
}

const OptionField& field_of(std::string_view name) { return find_option(name)->own; }

}  // namespace

TEST_CASE("a value that an option does not take is answered with those that it takes") {
    CHECK(answer_to("--frame-rate=0") ==
          "`--frame-rate=0`: must be a number above 0 to 1000, but it is `0` | ");
    CHECK(answer_to("--limit-steps=1.5") ==
          "`--limit-steps=1.5`: must be a whole number from 1 on, but it is `1.5` | ");
    CHECK(answer_to("--time=soon") ==
          "`--time=soon`: must be a time above 0: seconds, or a number with "
          "s, m or h, but it is `soon` | ");
    CHECK(answer_to("--memory=big") ==
          "`--memory=big`: must be a size: bytes, or a number with K, M, G "
          "or T, but it is `big` | ");
    CHECK(answer_to("--shard-by=tile") ==
          "`--shard-by=tile`: must be samples, tiles or frames, but it "
          "is `tile` | did you mean `tiles`?");
    CHECK(answer_to("--sandbox=maybe") ==
          "`--sandbox=maybe`: must be off or on, but it is `maybe` | ");
    CHECK(answer_to("+SR-1") == "`+SR-1`: must be a number from 0 on, but it is `-1` | ");
    CHECK(answer_to("--progress=jsn").ends_with("did you mean `json`?"));
}

TEST_CASE("a field tells its type, its range and its default") {
    CHECK(values(field_of("limit-steps")) == "whole number from 1 on, default 100 million");
    CHECK(values(field_of("limit-depth")) == "whole number from 1 to 100000000, default 200000");
    CHECK(values(field_of("limit-written")) == "whole number from 1 on, default 1024");
    CHECK(values(field_of("checkpoint")) ==
          "time: seconds, or a number with s, m or h, default 60s");
    CHECK(values(field_of("progress")) == "auto, plain, json, alf, openjd, povray or none, default auto");
    CHECK(values(field_of("shard-by")) == "samples, tiles or frames");
    CHECK(values(field_of("keep-state")).empty());
    CHECK(values(field_of("movie")).empty());
    CHECK(type_name(field_of("library-path").type) == "texts");
}

TEST_CASE("what differs from the usual value is written as it is given") {
    const auto changed = [](std::string_view name, std::string_view word) {
        std::string text;
        for (const std::string& each : changed_values(field_of(name), read({word})))
            text += each + ";";
        return text;
    };
    CHECK(changed("output-alpha", "+UA") == "on;");
    CHECK(changed("output-alpha", "-UA").empty());
    CHECK(changed("verbose", "-V") == "off;");
    CHECK(changed("time", "--time=1.5m") == "90s;");
    CHECK(changed("limit-said", "--limit-said=3") == "3;");
    CHECK(changed("progress", "--progress=none") == "none;");
    CHECK(changed("diagnostics", "--diagnostics=json") == "json;");
    CHECK(changed("sandbox", "--sandbox=off") == "off;");
    CHECK(changed("allow-read", "--allow-read=a") == "a;");
    CHECK(changed("frame-rate", "--frame-rate=25").empty());
}

TEST_CASE("every name of a progress but auto is a style") {
    for (const std::string_view name : field_of("progress").names)
        CHECK(progress_style(name).has_value() == (name != "auto"));
}

}  // namespace candelabra
