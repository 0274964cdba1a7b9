// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/said.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("strings are built from parts", "[interpret]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"#declare s = \"a\"; #declare s = concat(s, \"b\"); #debug s", "ab"},
        {"#declare s = \"a\"; #for (i, 1, 3) #declare s = concat(s, s); #end #debug s", "aaaaaaaa"},
        {"#declare s = \"\"; #for (i, 1, 12) #declare s = concat(s, str(mod(i, 10), 1, 0)); #end "
         "#debug s",
         "123456789012"},
        {"#declare s = \"a\"; #declare r = s; #declare s = concat(s, \"b\"); #debug concat(r, s)",
         "aab"},
        {"#macro M() #declare s = \"new\"; \"c\" #end #declare s = \"a\"; #declare s = concat(s, "
         "M()); "
         "#debug s",
         "ac"},
        {"#macro M() #declare s = concat(s, \"x\"); \"c\" #end #declare s = \"a\"; #declare s = "
         "concat(s, "
         "M()); #debug s",
         "ac"},
        {"#macro M(p) #declare p = concat(p, \"!\"); #end #declare s = array[2] {\"a\", \"b\"}; "
         "M(s[1]) "
         "#debug concat(s[0], s[1])",
         "ab!"},
        {"#macro M() #local s = concat(\"in \", s); #debug s #end #declare s = \"out\"; M() #debug "
         "s",
         "in outout"},
        {"#debug concat(concat(\"a\", concat(\"b\")), str(1.5, 6, 2), concat(\"\"))", "ab  1.50"},
        {"#debug concat(#if (1) \"a\" #else \"b\" #end, \"c\")", "ac"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

TEST_CASE("what is no string is reported once", "[interpret]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"#debug concat(\"a\", 2)", "error: `concat` takes a string here, but this is a number\n"},
        {"#declare s = concat(x); #debug s",
         "error: `concat` takes a string here, but this is a vector of 3\n"},
        {"#debug str(\"a\", 1, 1)", "error: `str` takes a number here, but this is a string\n"},
        {"#debug str(x, 1, 1)", "error: `str` takes a number here, but this is a vector of 3\n"},
        {"#debug concat()", "error: `concat` takes at least 1 argument, but here are 0\n"},
        {"#debug str(1, 2)", "error: `str` takes 3 arguments, but here are 2\n"},
        {"#declare s = concat(\"a\", nope);", "error: nothing is declared as `nope`\n"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

}  // namespace candelabra
