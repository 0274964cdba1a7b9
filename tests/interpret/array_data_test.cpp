// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/array_data.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("elements of an array are set, read and taken away", "[interpret]") {
    ArrayData array({2, 3});
    CHECK(array.size() == 6);
    CHECK_FALSE(array.has(4));
    CHECK(array.at(4).is(Absence::uninitialised));
    array.set(4, Numbers::scalar(5));
    CHECK(array.has(4));
    CHECK(array.count(4) == 1);
    CHECK(array.at(4).numbers()->at[0] == 5);
    array.clear(4);
    CHECK_FALSE(array.has(4));
    array.clear(4);
    CHECK_FALSE(array.has(4));
}

TEST_CASE("numbers of different lengths live in one array", "[interpret]") {
    ArrayData array({4});
    array.set(0, Numbers::scalar(1));
    array.set(1, Numbers::vector(Vec3(2, 3, 4)));
    array.set(2, Numbers{{5, 6}, 2});
    CHECK(array.max_numbers() == 3);
    CHECK(*array.at(0).numbers() == Numbers::scalar(1));
    CHECK(*array.at(1).numbers() == Numbers::vector(Vec3(2, 3, 4)));
    CHECK(*array.at(2).numbers() == Numbers{{5, 6}, 2});
    CHECK_FALSE(array.has(3));
}

TEST_CASE("elements are of one kind", "[interpret]") {
    ArrayData array({3});
    const Value text(std::string("s"));
    CHECK(array.fits(0, text));
    array.set(1, Numbers::scalar(1));
    CHECK_FALSE(array.fits(0, text));
    CHECK(array.fits(1, text));  // nothing else is set
    CHECK(kind_name(array.other(0)) == "a number");
    array.set(1, text);
    CHECK(array.count(1) == 0);
    CHECK(array.max_numbers() == 0);
    CHECK(array.fits(0, text));
    CHECK_FALSE(array.fits(0, Value(1.0)));
    array.set(1, Numbers::scalar(3));
    CHECK(array.count(1) == 1);
    CHECK(array.fits(2, Value(1.0)));
}

TEST_CASE("a value that does not fit is kept without losing the others", "[interpret]") {
    ArrayData array({3});
    array.set(0, Numbers::scalar(1));
    array.set(1, Value(std::string("s")));
    array.set(2, Numbers::scalar(2));
    CHECK(array.at(0).numbers()->at[0] == 1);
    CHECK(*array.at(1).text() == "s");
    CHECK(array.at(2).numbers()->at[0] == 2);
}

TEST_CASE("what was reported is not reported again when it is read", "[interpret]") {
    ArrayData array({2});
    array.set(0, Numbers::scalar(1));
    array.set(1, Value(Absence::broken));
    CHECK(array.at(1).broken());
    CHECK_FALSE(array.has(1));
    CHECK(array.at(0).numbers()->at[0] == 1);
    array.set(1, Numbers::vector(Vec3(1)));
    CHECK(array.count(1) == 3);
}

TEST_CASE("only an element that is an array can be edited inside", "[interpret]") {
    ArrayData array({2});
    CHECK(array.inner(0) == nullptr);
    array.set(0, Value(make_handle<ArrayData>(std::vector{1})));
    REQUIRE(array.inner(0) != nullptr);
    array.inner(0)->edit_array().set(0, Numbers::scalar(4));
    CHECK(array.at(0).array()->numbers(0)[0] == 4);
    CHECK(array.inner(1) == nullptr);
}

}  // namespace candelabra
