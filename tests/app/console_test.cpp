// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console.h"

#include <catch2/catch.hpp>

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
