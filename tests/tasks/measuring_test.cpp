// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measuring.h"

#include "options/command_line.h"
#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("what was measured goes to its file, or to the standard output") {
    Shell shell;
    Options options;
    Console console;
    std::string said;
    console.out = [&](std::string_view text) { said += text; };
    console.err = [](std::string_view) {};
    Diagnostics diagnostics;
    SceneSteps steps(options, console, diagnostics);
    options.readings_file = shell.path("a.csv");
    CHECK_FALSE(measures_as_json(options));
    CHECK(write_measured(steps, "table", "for people", false) == exit_status::done);
    CHECK(shell.content("a.csv") == "table");
    CHECK(said == "for people");
    said.clear();
    options.readings_file = "-";
    CHECK(write_measured(steps, "table", "for people", true) == exit_status::stopped);
    CHECK(said == "table");
    options.readings_file = shell.path("none/a.json");
    CHECK(measures_as_json(options));
    CHECK(write_measured(steps, "table", "for people", false) == exit_status::file);
}

TEST_CASE("a caller gets readings as JSON") {
    Options options;
    options.readings_file = "-";
    CHECK_FALSE(measures_as_json(options));
    options.for_caller = true;
    CHECK(measures_as_json(options));
}

TEST_CASE("measuring needs a table that it can write, and no denoiser") {
    Options options;
    const auto errors = [&] {
        Diagnostics diagnostics;
        check_measuring(options, diagnostics);
        return diagnostics.error_count();
    };
    options.readings_file = "a.csv";
    CHECK(errors() == 0);
    options.readings_file = "a.txt";
    CHECK(errors() == 1);
    options.denoise = true;
    CHECK(errors() == 2);
}

TEST_CASE("options of pictures have no effect on measuring, and that is said") {
    const auto said = [](std::vector<std::string_view> words) {
        words.insert(words.end(), {"a.pov", "--measure", "a.csv"});
        Diagnostics diagnostics;
        const Options options = read_options(words, diagnostics);
        check_measuring(options, diagnostics);
        std::string text;
        for (const Diagnostic& each : diagnostics.all()) text += each.message + "\n";
        return text;
    };
    CHECK(said({"+A", "+W640", "-V", "--samples", "16"}).empty());
    CHECK(has(said({"+C"}), "has no effect: --measure renders no picture"));
    CHECK(has(said({"+SR2"}), "has no effect"));
    CHECK(has(said({"--noise", "0.1"}), "has no effect"));
    CHECK(has(said({"--layers", "lights"}), "has no effect"));
    CHECK(has(said({"+Q3"}), "measures the light that pictures of quality 3 have"));
    CHECK(has(said({"--shard", "1/2", "--samples", "16"}), "has no shards"));
    CHECK_FALSE(has(said({"--shard", "1/2", "--shard-by", "frames"}), "has no shards"));
}

TEST_CASE("measuring ends by time and by signals") {
    Options options;
    Console console;
    Diagnostics diagnostics;
    SceneSteps steps(options, console, diagnostics);
    bool stopped = false;
    CHECK_FALSE(ends_measuring(steps, stopped)());
    options.time = 0;
    CHECK(ends_measuring(steps, stopped)());
    CHECK_FALSE(stopped);
    options.time.reset();
    console.interrupts.take = [] { return Interrupt::stop; };
    CHECK(ends_measuring(steps, stopped)());
    CHECK(stopped);
}

}  // namespace candelabra
