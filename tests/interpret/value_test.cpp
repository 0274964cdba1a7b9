// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/value.h"

#include "reading/binder.h"

#include "interpret/array_data.h"
#include "interpret/macro.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("numbers are promoted as in POV-Ray", "[interpret]") {
    CHECK(Numbers::scalar(2).promoted(3) == Numbers{{2, 2, 2}, 3});
    CHECK(Numbers{{1, 2}, 2}.promoted(4) == Numbers{{1, 2, 0, 0}, 4});
    CHECK(Numbers{{1, 2, 3}, 3}.promoted(2) == Numbers{{1, 2, 3}, 3});
    CHECK(Numbers::colour({Rgb(1, 2, 3), 4, 5}).to_colour() == Colour{Rgb(1, 2, 3), 4, 5});
}

TEST_CASE("a value tells what it is", "[interpret]") {
    CHECK(kind_name(Value(1.0)) == "a number");
    CHECK(kind_name(Value(Numbers::vector(Vec3(0)))) == "a vector of 3");
    CHECK(kind_name(Value(Numbers::colour({}))) == "a colour");
    CHECK(kind_name(Value(std::string("s"))) == "a string");
    CHECK(kind_name(Value(make_handle<ArrayData>(std::vector{1}))) == "an array");
    CHECK(kind_name(Value(Handle<Finish>())) == "a finish");
    CHECK(kind_name(Value(Handle<std::vector<ColourStop>>())) == "a colour map");
    CHECK(kind_name(Value(Handle<Spline>())) == "a spline");
    CHECK(kind_name(Value(Handle<Rainbow>())) == "a rainbow");
    const MacroData macro{};
    CHECK(kind_name(Value(&macro)) == "a macro");
    CHECK(Value(&macro).macro() == &macro);
    CHECK(Value(Absence::broken).broken());
    CHECK(Value(Absence::nothing).absent());
    CHECK_FALSE(Value(Absence::nothing).broken());
    CHECK(Value(1.0).same_kind(Value(Numbers::vector(Vec3(0)))));
    CHECK_FALSE(Value(1.0).same_kind(Value(std::string("s"))));
}

TEST_CASE("an array is copied when it is written to while shared", "[interpret]") {
    Value a(make_handle<ArrayData>(std::vector{1}));
    a.edit_array().set(0, Numbers::scalar(1));
    Value b = a;
    const ArrayData* shared = a.array();
    b.edit_array().set(0, Numbers::scalar(2));
    CHECK(a.array() == shared);
    CHECK(a.array()->numbers(0)[0] == 1);
    CHECK(b.array()->numbers(0)[0] == 2);
    const ArrayData* own = b.array();
    b.edit_array();
    CHECK(b.array() == own);
}

TEST_CASE("a string can be written to while nothing shares it", "[interpret]") {
    Value a(std::string("one"));
    REQUIRE(a.own_text() != nullptr);
    *a.own_text() += " more";
    CHECK(*a.text() == "one more");
    const Value b = a;
    CHECK(a.own_text() == nullptr);
    CHECK(Value(1.0).own_text() == nullptr);
}

TEST_CASE("values are copied and moved whatever they hold", "[interpret]") {
    const std::vector<Value> values = {Value(Absence::broken), Value(2.0),
                                       Value(std::string("text")),
                                       Value(make_handle<ArrayData>(std::vector{2}))};
    for (const Value& from : values)
        for (const Value& to : values) {
            Value target = to;
            target = from;
            CHECK(kind_name(target) == kind_name(from));
            Value moved = std::move(target);
            target = to;
            target = std::move(moved);
            CHECK(kind_name(target) == kind_name(from));
            CHECK(target.text() == from.text());
        }
}

}  // namespace candelabra
