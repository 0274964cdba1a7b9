// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/kinds.h"

#include "vocabulary/schema.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

struct Apple {
    double size = 1;
    static const ItemInfo vocabulary;
};

const ItemInfo Apple::vocabulary = described<Apple>([] {
    return schema<Apple>("apple", "A fruit.",
                         Field<Apple>{"size", &Apple::size, positional, "diameter"});
});

struct Pear {
    double length = 2;
    static const ItemInfo vocabulary;
};

const ItemInfo Pear::vocabulary = described<Pear>([] {
    return schema<Pear>("pear", "A longer one.",
                        Field<Pear>{"length", &Pear::length, positional, "length"});
});

using Fruit = std::variant<Apple, Shared<Pear>>;

}  // namespace

TEST_CASE("kinds are found by their keywords", "[vocabulary]") {
    CHECK(Kinds<Fruit>::count == 2);
    CHECK(Kinds<Fruit>::find("apple") == 0);
    CHECK(Kinds<Fruit>::find("pear") == 1);
    CHECK(Kinds<Fruit>::find("plum") == Kinds<Fruit>::count);
    CHECK(Kinds<Fruit>::find("") == Kinds<Fruit>::count);
    CHECK(Kinds<Fruit>::infos[1]->help == "A longer one.");
}

TEST_CASE(
    "a fresh kind is filled in where it is stored, and copies of a shared one stay as they were",
    "[vocabulary]") {
    for (std::size_t i = 0; i < Kinds<Fruit>::count; ++i) {
        Fruit fruit = Kinds<Fruit>::make(i);
        CHECK(fruit.index() == i);
        const Fruit copy = fruit;
        const ItemInfo& info = *Kinds<Fruit>::infos[i];
        const FieldValue before = info.default_value(0);
        info.set(Kinds<Fruit>::address(fruit), 0, 9.0);
        CHECK(info.get(Kinds<Fruit>::address(fruit), 0) == FieldValue(9.0));
        Fruit other = copy;
        CHECK(info.get(Kinds<Fruit>::address(other), 0) == before);
    }
}

}  // namespace candelabra
