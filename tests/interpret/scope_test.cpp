// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/scope.h"

#include "interpret/array_data.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

constexpr NameId a{1}, b{2};

double number(const Scope& scope, NameId name) {
    return scope.find(name) ? scope.find(name)->numbers()->at[0] : -1;
}

}  // namespace

TEST_CASE("a frame hides and gives back", "[interpret]") {
    Scope scope;
    CHECK(scope.find(a) == nullptr);
    scope.declare(a, 1.0);
    scope.enter();
    scope.declare_local(a, 2.0);
    scope.declare_local(b, 3.0);
    CHECK(number(scope, a) == 2);
    scope.enter();
    CHECK(number(scope, b) == 3);
    scope.declare(b, 4.0);
    scope.leave();
    CHECK(number(scope, b) == 4);
    scope.leave();
    CHECK(number(scope, a) == 1);
    CHECK(scope.find(b) == nullptr);
    CHECK(scope.names() == std::vector<NameId>{a});
}

TEST_CASE("#declare in a frame makes a global name", "[interpret]") {
    Scope scope;
    scope.enter();
    scope.declare(a, 1.0);
    scope.declare_local(a, 2.0);
    scope.leave();
    CHECK(number(scope, a) == 1);
}

TEST_CASE("an alias is the same variable", "[interpret]") {
    Scope scope;
    scope.declare(a, 1.0);
    const Scope::Reference reference = scope.reference(a);
    scope.enter();
    scope.alias(b, reference);
    scope.declare(b, 5.0);
    CHECK(number(scope, a) == 5);
    CHECK(scope.undefine(b));
    CHECK(scope.find(b) == nullptr);
    scope.leave();
    CHECK(number(scope, a) == 5);
}

TEST_CASE("an alias to an element follows the array, and the array follows it", "[interpret]") {
    Scope scope;
    ArrayData array({2});
    array.set(0, Numbers::scalar(1));
    array.set(1, Numbers::scalar(2));
    scope.declare(a, Value(make_handle<ArrayData>(array)));
    scope.enter();
    scope.alias(b, {scope.reference(a).cell, 1});
    CHECK(number(scope, b) == 2);
    CHECK(scope.reference(b).element == 1);
    CHECK(scope.overwritable(b, false) == nullptr);
    scope.declare(b, 7.0);
    CHECK(scope.find(a)->array()->numbers(1)[0] == 7);
    scope.edit(a)->edit_array().set(1, Numbers::scalar(8));
    scope.edited();
    CHECK(number(scope, b) == 8);
    scope.declare(a, 0.0);
    CHECK(scope.find(b)->is(Absence::uninitialised));
    scope.leave();
    CHECK(scope.find(b) == nullptr);
}

TEST_CASE("an array in an array is edited in place through an alias", "[interpret]") {
    Scope scope;
    ArrayData outer({1});
    outer.set(0, Value(make_handle<ArrayData>(std::vector{1})));
    scope.declare(a, Value(make_handle<ArrayData>(outer)));
    scope.enter();
    scope.alias(b, {scope.reference(a).cell, 0});
    scope.edit(b)->edit_array().set(0, Numbers::scalar(5));
    scope.edited();
    CHECK(scope.find(b)->array()->numbers(0)[0] == 5);
    CHECK(scope.find(a)->array()->at(0).array()->numbers(0)[0] == 5);
    scope.leave();
}

TEST_CASE("numbers are overwritten where #declare would change them", "[interpret]") {
    Scope scope;
    CHECK(scope.overwritable(a, false) == nullptr);
    scope.declare(a, 1.0);
    CHECK(scope.overwritable(a, true) != nullptr);
    scope.enter();
    CHECK(scope.overwritable(a, true) == nullptr);
    REQUIRE(scope.overwritable(a, false) != nullptr);
    *scope.overwritable(a, false) = Numbers::scalar(4);
    CHECK(number(scope, a) == 4);
    scope.declare(a, Value(std::string("s")));
    CHECK(scope.overwritable(a, false) == nullptr);
    scope.leave();
}

TEST_CASE("a parameter by value has a cell of its own", "[interpret]") {
    Scope scope;
    scope.declare(a, 1.0);
    Value* cell = scope.fresh_cell();
    *cell = 6.0;
    scope.enter();
    scope.bind_parameter(a, cell);
    CHECK(number(scope, a) == 6);
    scope.leave();
    CHECK(number(scope, a) == 1);
    CHECK(scope.fresh_cell() == cell);
    scope.give_back(cell);
}

TEST_CASE("undefine takes the newest binding away", "[interpret]") {
    Scope scope;
    CHECK_FALSE(scope.undefine(a));
    scope.declare(a, 1.0);
    scope.enter();
    scope.declare_local(a, 2.0);
    scope.declare_local(b, 3.0);
    scope.enter();
    CHECK(scope.undefine(a));
    CHECK(number(scope, a) == 1);
    scope.leave();
    CHECK(number(scope, b) == 3);
    scope.leave();
    CHECK(number(scope, a) == 1);
    CHECK(scope.undefine(a));
    CHECK(scope.find(a) == nullptr);
}

}  // namespace candelabra
