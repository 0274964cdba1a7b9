// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/string_functions.h"

#include "interpret/said.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <random>

namespace candelabra {

TEST_CASE("functions of strings have POV-Ray's values", "[interpret]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {R"(#debug str(1.5,0,2) #debug str(2,8,1) #debug str(-2,-6,1) #debug str(1/3,0,-1))",
         "1.50     2.0-002.00.333333"},
        {R"(#debug vstr(2,<1,2,3>,",",0,1) #debug "|" #debug vstr(5,<1,2>,",",0,1) #debug "|" #debug vstr(1,<1,2,3>,",",0,1))",
         "1.0,2.0|1.0,2.0,0.0,0.0,0.0|1.0,2.0"},
        {R"(#debug vstr(7,<1,2,3>,";",6,2) #debug "|" #debug vstr(3,2,",",0,1))",
         "  1.00;  2.00;  3.00;  0.00;  0.00|2.0,0.0,0.0"},
        {R"(#debug concat("a","b","c") #debug substr("abcdef",2,3) #debug strupr("aBc") #debug strlwr("aBc"))",
         "abcbcdABCabc"},
        {R"(P(strlen("abc")) P(strlen("")) P(strlen("\u00e9x")) P(asc("A")) P(asc("")))",
         "3.000000 0.000000 2.000000 65.000000 0.000000"},
        {R"(P(val("1.5e1x")) P(val("")) P(strcmp("a","c")) P(strcmp("abc","ab")) P(strcmp("a","a")))",
         "15.000000 0.000000 -2.000000 99.000000 0.000000"},
        {R"(#debug chr(65) #debug chr(233) #debug chr(8364) #debug substr("h\u00e9h",2,1))",
         "A\u00e9\u20ac\u00e9"},
        {R"(#debug datetime(0) #debug "|" #debug datetime(366.5, "%d.%m.%y %H"))",
         "2000-01-01 00:00:00Z|01.01.01 12"},
        {"#debug str(strlen(\"a\nb\"),0,0) #debug \" \" #debug str(asc(substr(\"a\nb\",2,1)),0,0)",
         "3 10"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

TEST_CASE("what a function of strings cannot take is reported", "[interpret]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"#debug chr(65536)", "error: a character's code is from 0 to 65535, but this is 65536\n"},
        {"#debug substr(\"abc\", -1, 1)",
         "error: the string has characters 1 to 3, and this is -1\n"},
        {"#debug substr(\"abc\", 2, 3)",
         "error: from 2 on the string has 2 characters, but the length is 3\n"},
        {"#debug concat(\"a\", 1)", "error: `concat` takes a string here, but this is a number\n"},
        {"#debug str(1)", "error: `str` takes 3 arguments, but here is 1\n"},
        {"P(strlen(5))", "error: `strlen` takes a string here, but this is a number\n"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

TEST_CASE("numbers are written as C writes them", "[interpret]") {
    const auto same = [](double value, int width, int digits) {
        std::array<char, 1500> expected;
        std::snprintf(expected.data(), expected.size(), width < 0 ? "%0*.*f" : "%*.*f",
                      std::abs(width), digits < 0 ? 6 : digits, value);
        std::string text = "+";
        append_formatted(text, value, width, digits);
        CHECK(text == "+" + std::string(expected.data()));
    };
    const double edges[] = {0.0,    -0.0,     0.5,       1.5,      2.5,     -0.4,  -0.5,
                            0.125,  999.9999, 1e15,      9.007e15, 1.23e17, 1e300, -1e300,
                            1e-300, INFINITY, -INFINITY, 0.1,      2.675,   1e22,  5e-324};
    for (const double value : edges)
        for (const int width : {0, 1, 12, -12, -1, 400, -400})
            for (const int digits : {-1, 0, 1, 2, 3, 17, 400}) same(value, width, digits);
    std::mt19937_64 random(7);
    for (int i = 0; i < 20000; ++i) {
        const double value = std::ldexp(static_cast<double>(random()) - 9.2e18,
                                        static_cast<int>(random() % 130) - 100);
        same(value, static_cast<int>(random() % 30) - 15, static_cast<int>(random() % 20));
    }
}

}  // namespace candelabra
