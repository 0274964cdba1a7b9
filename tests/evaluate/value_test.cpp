// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/value.h"

#include <catch2/catch.hpp>

TEST_CASE("numbers are promoted as in POV-Ray", "[evaluate]") {
    CHECK(Numbers::scalar(2).promoted(3) == Numbers{{2, 2, 2}, 3});
    CHECK(Numbers{{1, 2}, 2}.promoted(4) == Numbers{{1, 2, 0, 0}, 4});
    CHECK(Numbers{{1, 2, 3}, 3}.promoted(2) == Numbers{{1, 2, 3}, 3});
    CHECK(Numbers::colour({Vec3(1, 2, 3), 4, 5}).to_colour() == Colour{Vec3(1, 2, 3), 4, 5});
}

TEST_CASE("a value tells what it is", "[evaluate]") {
    CHECK(kind_name(Value(1.0)) == "a number");
    CHECK(kind_name(Value(Numbers::vector(Vec3(0)))) == "a vector of 3");
    CHECK(kind_name(Value(Numbers::colour({}))) == "a colour");
    CHECK(kind_name(Value(std::string("s"))) == "a string");
    CHECK(kind_name(Value(std::make_shared<ArrayData>())) == "an array");
    CHECK(kind_name(Value(Handle<Finish>())) == "a finish");
    CHECK(Value(Absence::broken).broken());
    CHECK(Value(Absence::nothing).absent());
    CHECK_FALSE(Value(Absence::nothing).broken());
    CHECK(Value(1.0).same_kind(Value(Numbers::vector(Vec3(0)))));
    CHECK_FALSE(Value(1.0).same_kind(Value(std::string("s"))));
}

TEST_CASE("an array is copied when it is written to while shared", "[evaluate]") {
    Value a(std::make_shared<ArrayData>(ArrayData{{1}, {Value(1.0)}}));
    Value b = a;
    const ArrayData* shared = a.array();
    b.edit_array().elements[0] = Value(2.0);
    CHECK(a.array() == shared);
    CHECK(a.array()->elements[0].numbers()->at[0] == 1);
    CHECK(b.array()->elements[0].numbers()->at[0] == 2);
    const ArrayData* own = b.array();
    b.edit_array();
    CHECK(b.array() == own);
}
