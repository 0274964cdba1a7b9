// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/scope.h"

#include <catch2/catch.hpp>

namespace {

constexpr NameId a{1}, b{2};

double number(const Scope& scope, NameId name) {
    return scope.find(name) ? scope.find(name)->numbers()->at[0] : -1;
}

}  // namespace

TEST_CASE("a frame hides and gives back", "[evaluate]") {
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

TEST_CASE("#declare in a frame makes a global name", "[evaluate]") {
    Scope scope;
    scope.enter();
    scope.declare(a, 1.0);
    scope.declare_local(a, 2.0);
    scope.leave();
    CHECK(number(scope, a) == 1);
}

TEST_CASE("an alias is the same variable", "[evaluate]") {
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

TEST_CASE("an alias to an element follows the array", "[evaluate]") {
    Scope scope;
    scope.declare(a, Value(std::make_shared<ArrayData>(ArrayData{{2}, {Value(1.0), Value(2.0)}})));
    const Scope::Reference reference{scope.reference(a).cell, 1};
    scope.enter();
    scope.alias(b, reference);
    CHECK(number(scope, b) == 2);
    scope.declare(b, 7.0);
    CHECK(scope.find(a)->array()->elements[1].numbers()->at[0] == 7);
    scope.declare(a, 0.0);
    CHECK(scope.find(b) == nullptr);
    scope.leave();
}

TEST_CASE("undefine takes the newest binding away", "[evaluate]") {
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
