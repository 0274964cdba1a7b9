// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/tree.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("operators are spelt as they are written", "[syntax]") {
    CHECK(spelling(Operator::add) == "+");
    CHECK(spelling(Operator::not_equal) == "!=");
    CHECK(spelling(Operator::no) == "!");
}

TEST_CASE("a node is found by its kind", "[syntax]") {
    Tree tree;
    tree.source = 3;
    const NodeId id = tree.add({3, 5, 9}, node::Name{NameId(7)});
    CHECK(tree[id].content.index() == kind<node::Name>);
    CHECK(tree.get<node::Name>(id).name == NameId(7));
    CHECK(tree.get_if<node::Number>(id) == nullptr);
    CHECK(tree.get_if<node::Number>(no_node) == nullptr);
    CHECK(tree.span(id) == Span{3, 5, 9});
}

}  // namespace candelabra
