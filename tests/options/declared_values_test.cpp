// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/declared_values.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("declared values are numbers, switches, strings, vectors and colours") {
    CHECK(declared_value("0.5") == DeclaredValue(0.5));
    CHECK(declared_value("on") == DeclaredValue(1.0));
    CHECK(declared_value("\"a b\"") == DeclaredValue(std::string("a b")));
    CHECK(declared_value("<1, -2, 3>") == DeclaredValue(Numbers::vector(Vec3(1, -2, 3))));
    CHECK(declared_value("<1,2>") == DeclaredValue(Numbers{{1, 2}, 2}));
    CHECK(declared_value("rgb <1, 0.5, 0>") ==
          DeclaredValue(Numbers::colour({Rgb(1, 0.5, 0), 0, 0})));
    for (const char* text : {"", "x", "<1>", "<>", "<1,,2>", "<1,2", "<1,2,3,4,5,6>", "<1,x>",
                             "rgb 1", "rgb <1, 2>", "rgb", "1+2"}) {
        CAPTURE(text);
        CHECK_FALSE(declared_value(text));
    }
    for (const char* text : {"0.5", "\"a\"", "<1, -2, 3>", "<1, 2>", "rgb <1, 0.5, 0>"})
        CHECK(text_of(*declared_value(text)) == text);
}

TEST_CASE("a set of values is a JSON object of names") {
    std::string problem;
    const auto set = preset(R"({ "B": 2, "A": true, "Name": "x", "At": [1, 2, 3],
                                 "Tint": { "rgb": [1, 0.5, 0] } })",
                            problem);
    REQUIRE(set.has_value());
    CHECK(problem.empty());
    REQUIRE(set->size() == 5);
    CHECK(((*set)[0] == Declaration("B", 2.0)));
    CHECK(((*set)[1] == Declaration("A", 1.0)));
    CHECK(((*set)[2] == Declaration("Name", std::string("x"))));
    CHECK(((*set)[3] == Declaration("At", Numbers::vector(Vec3(1, 2, 3)))));
    CHECK(((*set)[4] == Declaration("Tint", Numbers::colour({Rgb(1, 0.5, 0), 0, 0}))));
    for (const char* text :
         {"", "[1]", "{", "{\"A\": null}", "{\"A\": [1]}", "{\"A\": [1, \"x\"]}",
          "{\"A\": {\"rgb\": 1}}", "{\"A\": {}}", "{\"sphere\": 1}", "{\"a b\": 1}"}) {
        CAPTURE(text);
        CHECK_FALSE(preset(text, problem).has_value());
        CHECK_FALSE(problem.empty());
    }
}

}  // namespace candelabra
