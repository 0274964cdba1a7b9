// SPDX-License-Identifier: GPL-3.0-or-later
#include "console/console.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

#include <cstdlib>

namespace candelabra {

TEST_CASE("errors are said as text or as JSON") {
    std::string heard;
    Console console;
    console.err = [&](std::string_view text) { heard += text; };
    Diagnostics diagnostics;
    diagnostics.add(error(Fault::option, {}, "wrong"));
    Options options;
    say_errors(console, options, diagnostics);
    CHECK(heard == "error: wrong\n");
    heard.clear();
    options.diagnostics_as_json = true;
    say_errors(console, options, diagnostics);
    CHECK(heard.starts_with("{"));
}

TEST_CASE("a caller gets diagnostics as data, too") {
    std::vector<Fault> faults;
    Console console;
    console.err = [](std::string_view) {};
    console.diagnosed = [&](const Diagnostic& each, const SourceStore&) {
        faults.push_back(each.fault);
    };
    Diagnostics diagnostics;
    diagnostics.add(error(Fault::option, {}, "wrong"));
    say_errors(console, {}, diagnostics);
    CHECK(faults == std::vector<Fault>{Fault::option});
}

TEST_CASE("a reader who has read enough is no error, and a full disk is one") {
    const Shell shell;
    const auto said = [&](const std::string& command) {
        REQUIRE(std::system((command + " 2> " + shell.path("said") + " | true").c_str()) == 0);
        return shell.content("said");
    };
    CHECK(said("sh -c 'sleep 0.3; " CANDELABRA_BINARY " --help'").empty());
    CHECK(has(said("sh -c '" CANDELABRA_BINARY " --help > /dev/full'"), "cannot write"));
}

}  // namespace candelabra
