// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/subcommands.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("options of subcommands are taken from the others, with their values", "[options]") {
    struct Row {
        const char* subcommand;
        std::vector<std::string_view> arguments;
        const char *taken, *others;
    };
    const Row rows[] = {
        {"relight",
         {"--set", "A=1", "x", "--csv=f", "--lamps"},
         "--set A=1,--csv f,--lamps ,",
         "x,"},
        {"relight", {"-o", "a.png"}, "", "+Oa.png,"},
        {"relight", {"--output=a.png", "--samples", "4"}, "", "+Oa.png,--samples,4,"},
        {"relight", {"--lamps=2", "--set", "--csv"}, "--set --csv,", "--lamps=2,"},
        {"solve", {"+Oa", "-o", "b", "--output=c"}, "--output a,--output b,--output c,", ""},
        {"fmt", {"-o", "--", "--check"}, "", "-o,--,--check,"},
        {"fmt", {"--check", "a", ""}, "--check ,", "a,,"},
    };
    for (const Row& row : rows) {
        std::string taken, others;
        Diagnostics diagnostics;
        for (const std::string& other : take_options(
                 row.subcommand, row.arguments,
                 [&](std::string_view name, const std::string&value) {
                     taken += std::string(name) + " " + value + ",";
                 },
                 diagnostics))
            others += other + ",";
        CAPTURE(row.subcommand, row.arguments);
        CHECK(taken == row.taken);
        CHECK(others == row.others);
        CHECK_FALSE(diagnostics.failed());
    }
}

TEST_CASE("an option of a subcommand that needs a value says so", "[options]") {
    for (const std::string_view last : {"--set", "-o", "--output"}) {
        Diagnostics diagnostics;
        const std::vector<std::string_view> arguments = {"a", last};
        take_options(
            "relight", arguments, [](std::string_view, const std::string&) { FAIL(); },
            diagnostics);
        REQUIRE(diagnostics.all().size() == 1);
        CHECK(diagnostics.all()[0].message == "`" + std::string(last) + "` needs a value");
    }
}

}  // namespace candelabra
