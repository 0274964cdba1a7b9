// SPDX-License-Identifier: GPL-3.0-or-later
// Looks back in a list of a tree, which is linked forwards only. For messages that depend on the
// element before a place.
#pragma once

#include "syntax/tree.h"

namespace candelabra {

/// The node before `node` in its list, or no_node. Takes time in proportion to the tree.
inline NodeId previous(const Tree& tree, NodeId node) {
    for (auto id = static_cast<std::uint32_t>(node); id-- > 0;)
        if (tree.nodes[id].next == node) return NodeId(id);
    return no_node;
}

}  // namespace candelabra
