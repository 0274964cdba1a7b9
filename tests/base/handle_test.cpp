// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/handle.h"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace candelabra {

namespace {

struct Unknown;

/// Counts its live instances.
struct Counted {
    explicit Counted(int& count) : count(count) { ++count; }
    Counted(const Counted& other) : count(other.count) { ++count; }
    ~Counted() { --count; }
    int& count;
};

}  // namespace

TEST_CASE("a handle holds its value as long as any copy of it lives", "[base]") {
    int count = 0;
    Handle<Counted> first = make_handle<Counted>(count);
    Handle<Counted> second = first;
    CHECK(count == 1);
    CHECK(first == second);
    CHECK(!first.alone());
    first = nullptr;
    CHECK(count == 1);
    CHECK(second.alone());
    Handle<Counted> third = std::move(second);
    CHECK(!second);
    CHECK(count == 1);
    third = make_handle<Counted>(count);
    CHECK(count == 1);
    third = nullptr;
    CHECK(count == 0);
}

TEST_CASE("a handle assigned to itself keeps its value", "[base]") {
    Handle<std::string> text = make_handle<std::string>("abc");
    const Handle<std::string>& same = text;
    text = same;
    CHECK(*text == "abc");
    CHECK(text.alone());
}

TEST_CASE("editing through one handle changes no other", "[base]") {
    Handle<std::vector<int>> first = make_handle<std::vector<int>>(std::vector{1, 2, 3});
    Handle<std::vector<int>> second = first;
    second.edit().push_back(4);
    CHECK(first->size() == 3);
    CHECK(second->size() == 4);
    const auto* place = second.get();
    second.edit().push_back(5);
    CHECK(second.get() == place);
}

TEST_CASE("handles to one value are equal, handles to equal values are not", "[base]") {
    const Handle<int> one = make_handle<int>(1), again = make_handle<int>(1), copy = one;
    CHECK(one == copy);
    CHECK(!(one == again));
    CHECK(Handle<int>() == Handle<int>(nullptr));
    CHECK(sizeof(Handle<Unknown>) == sizeof(void*));
}

TEST_CASE("a handle may forget its type", "[base]") {
    const Handle<std::string> text = make_handle<std::string>("abc");
    AnyHandle any(text);
    CHECK(any.get() == text.get());
    CHECK_FALSE(any.alone());
    CHECK(any.as<std::string>() == text);
    any.edit<std::string>() += "d";
    CHECK(*text == "abc");
    CHECK(*any.as<std::string>() == "abcd");
    CHECK(any.alone());
    const AnyHandle copy = any;
    CHECK_FALSE(any.alone());
    any = AnyHandle(text);
    CHECK(copy.alone());
    CHECK_FALSE(text.alone());
    any = AnyHandle(Handle<std::string>());
    CHECK(any.get() == nullptr);
    CHECK(text.alone());
}

}  // namespace candelabra
