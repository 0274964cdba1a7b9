// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/code.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Tree tree_of(std::size_t nodes) {
    Tree tree;
    tree.source = 2;
    for (std::size_t i = 0; i < nodes; ++i) tree.add({}, node::Broken{});
    return tree;
}

}  // namespace

TEST_CASE("a node is compiled when it is met again", "[interpret]") {
    const Tree tree = tree_of(3);
    CodeTable table;
    table.add(tree);
    const NodeId id{1};
    CHECK(table.find(tree, id) == nullptr);
    CHECK_FALSE(table.wanted(tree, id));
    CHECK(table.wanted(tree, id));
    Code* const code = table.keep(tree, id, {});
    CHECK(table.find(tree, id) == code);
    CHECK(table.find(tree, NodeId{2}) == nullptr);
}

TEST_CASE("a node has few versions, the newest first", "[interpret]") {
    const Tree tree = tree_of(1);
    CodeTable table;
    table.add(tree);
    const NodeId id{0};
    table.wanted(tree, id);
    Code* before = nullptr;
    int versions = 0;
    for (; table.wanted(tree, id); ++versions) {
        REQUIRE(versions < 100);
        Code* const code = table.keep(tree, id, {});
        CHECK(table.find(tree, id) == code);
        CHECK(code->other.get() == before);
        before = code;
    }
    CHECK(versions == 4);
}

TEST_CASE("what cannot be compiled is not tried for ever", "[interpret]") {
    const Tree tree = tree_of(2);
    CodeTable table;
    table.add(tree);
    int tries = 0;
    for (int i = 0; i < 100; ++i) tries += table.wanted(tree, NodeId{0});
    CHECK(tries == 4);
    table.exclude(tree, NodeId{1});
    for (int i = 0; i < 100; ++i) CHECK_FALSE(table.wanted(tree, NodeId{1}));
}

}  // namespace candelabra
