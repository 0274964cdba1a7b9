// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/depfile.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a rule names all files once, as make reads them") {
    CHECK(depfile("a b.png", {{"s.pov", "1"}, {"x/$y#.inc", "2"}, {"s.pov", "3"}, {"-", "4"}}) ==
          "a\\ b.png: \\\n  s.pov \\\n  x/$$y\\#.inc\n");
}

TEST_CASE("names that make would obey are refused, with their files") {
    CHECK(unnameable_in_depfile("a b.png", {{"s.pov", "1"}, {"x/$y#%.inc", "2"}}).empty());
    for (const char* name : {"b\n\ttouch\tPWNED", "a\nSHELL=./evil.sh", "a;touch PWNED", "SHELL=.",
                             "a|b", "a\rb", "a\x7F"}) {
        CAPTURE(name);
        CHECK(unnameable_in_depfile("a.png", {{"s.pov", "1"}, {name, "2"}}) == name);
        CHECK(unnameable_in_depfile(name, {{"s.pov", "1"}}) == name);
    }
}

TEST_CASE("no rule is written for names that make would obey") {
    Shell shell;
    shell.write("b;touch PWNED", "1");
    shell.write("s.pov", "#fopen F \"b;touch PWNED\" read\n" + std::string(lit_scene));
    CHECK(shell({shell.path("s.pov"), "-V", "+W4", "+H4", "+O" + shell.path("a.png"), "--depfile",
                 shell.path("a.d")}) == exit_status::file);
    CHECK(has(shell.err, "a rule of make cannot name `"));
    CHECK_FALSE(std::filesystem::exists(shell.path("a.d")));
    shell.write("b\n\ttouch\tPWNED", "1");
    shell.write("s.pov",
                "#fopen F concat(\"b\", chr(10), chr(9), \"touch\", chr(9), \"PWNED\") read\n" +
                    std::string(lit_scene));
    CHECK(shell({shell.path("s.pov"), "-V", "+W4", "+H4", "+O" + shell.path("a.png")}) ==
          exit_status::scene);
    CHECK(has(shell.err, "a scene may not read"));
}

TEST_CASE("the rule of --depfile is written beside the picture") {
    Shell shell;
    shell.write("part.inc", "#declare Size = 2;");
    shell.write("s.pov", "#include \"part.inc\"\n" + std::string(lit_scene));
    CHECK(shell({shell.path("s.pov"), "-V", "+W4", "+H4", "+O" + shell.path("a.png"), "--depfile",
                 shell.path("a.d")}) == 0);
    CHECK(shell.content("a.d") == shell.path("a.png") + ": \\\n  " + shell.path("s.pov") +
                                      " \\\n  " + shell.path("part.inc") + "\n");
}

}  // namespace candelabra
