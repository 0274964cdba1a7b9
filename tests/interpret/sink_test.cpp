// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/sink.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a sink hands on elements, values among them", "[interpret]") {
    std::vector<Element::Kind> kinds;
    const auto take = [&](const Element& element) { kinds.push_back(element.kind); };
    const Sink sink(take);
    sink(Element{});
    Tree tree;
    sink.value(3.0, tree, tree.add({}, node::Broken{}));
    CHECK(kinds == std::vector{Element::Kind::word, Element::Kind::value});
}

TEST_CASE("one value takes the first and counts the rest", "[interpret]") {
    ElementHandlers handlers;
    handlers.value = [](std::span<const Element>) { return Value(std::string("block")); };
    OneValue one{handlers};
    const Sink sink(one);
    Tree tree;
    const NodeId id = tree.add({}, node::Broken{});
    SECTION("values") {
        sink.value(3.0, tree, id);
        sink.value(4.0, tree, id);
        CHECK(one.count == 2);
        CHECK(one.value.numbers()->at[0] == 3);
        CHECK_FALSE(one.first);
        CHECK_FALSE(one.broken);
    }
    SECTION("a block becomes a value at once") {
        Element block;
        block.kind = Element::Kind::block;
        sink(block);
        CHECK(*one.value.text() == "block");
        CHECK_FALSE(one.first);
    }
    SECTION("a word is no value") {
        sink(Element{});
        REQUIRE(one.first);
        CHECK(one.first->kind == Element::Kind::word);
        CHECK(one.count == 1);
    }
    SECTION("what has been reported is remembered") {
        sink.value(1.0, tree, id);
        sink.value(Absence::broken, tree, id);
        CHECK(one.broken);
    }
}

TEST_CASE("a sink may take what is written instead", "[interpret]") {
    std::vector<NodeId> taken;
    const auto take = [&](const Tree&, NodeId id) { taken.push_back(id); };
    const Sink::Written written(take);
    const Sink sink(written);
    Tree tree;
    const NodeId id = tree.add({}, node::Broken{});
    REQUIRE(sink.written());
    (*sink.written())(tree, id);
    CHECK(taken == std::vector{id});
}

}  // namespace candelabra
