// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/code.h"

namespace candelabra {

void CodeTable::add(const Tree& tree) {
    if (nodes_.size() <= tree.source) nodes_.resize(tree.source + 1);
    nodes_[tree.source].assign(tree.nodes.size(), 0);
}

bool CodeTable::wanted(const Tree& tree, NodeId id) {
    std::uint32_t& state = this->state(tree, id);
    if (state >= compiled) return codes_[state - compiled]->versions < max_versions;
    if (state == never) return false;
    return state++ >= met;
}

Code* CodeTable::keep(const Tree& tree, NodeId id, Code code) {
    std::uint32_t& state = this->state(tree, id);
    auto made = std::make_unique<Code>(std::move(code));
    if (state < compiled) {
        state = compiled + static_cast<std::uint32_t>(codes_.size());
        codes_.push_back(std::move(made));
    } else {
        std::unique_ptr<Code>& newest = codes_[state - compiled];
        made->versions = newest->versions + 1;
        made->other = std::move(newest);
        newest = std::move(made);
    }
    return codes_[state - compiled].get();
}

void CodeTable::exclude(const Tree& tree, NodeId id) {
    std::uint32_t& state = this->state(tree, id);
    if (state < compiled) state = never;
}

}  // namespace candelabra
