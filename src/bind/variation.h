// SPDX-License-Identifier: GPL-3.0-or-later
// What differs from one pass of a loop to the next in an object's block that is otherwise the same:
// the values that its shape begins with, the colour of its only pigment, and where it is moved to
// at its end. Found out once for each block, then computed in each pass. Used by ShapePlan.
#pragma once

#include "base/colour.h"
#include "base/transform.h"
#include "interpret/evaluator.h"

#include <array>
#include <optional>

namespace candelabra {

/// What one pass says.
struct Variation {
    static constexpr std::size_t most = 6;

    std::array<Numbers, most> values;  ///< that the shape begins with
    std::size_t count = 0;
    Colour colour;                      ///< of its only pigment
    std::optional<Transform> movement;  ///< by what ends the block
};

/// Where a block says it.
class Variable {
public:
    /// Nothing when something else may differ, too, or what differs could mean something else each
    /// time. `values` is how many the shape needs.
    static std::optional<Variable> find(Evaluator&, const Body& block, std::size_t values);

    bool coloured() const { return colour_ != no_node; }
    bool moved() const { return movements_ != no_node; }
    /// Nothing varies but the values.
    bool plain() const { return !coloured() && !moved(); }
    /// Those on which the rest of the block depends.
    const std::vector<NameId>& names() const { return names_; }

    /// What the block says now, put into a new Variation; false when it is anything unusual. Random
    /// numbers are drawn, so the caller makes it an attempt of the evaluator.
    bool compute(Evaluator&, const Body& block, Variation&) const;

private:
    bool analyse(Evaluator&, const Tree&, NodeId first);
    bool take_rest(const Tree&, NodeId first);
    bool take_look(const Tree&, NodeId id);
    bool compute_movement(Evaluator&, const Tree&, std::optional<Transform>& result) const;

    std::size_t values_ = 0;
    NodeId colour_ = no_node;     ///< `rgb ...`
    NodeId movements_ = no_node;  ///< the first word of `translate ... rotate ...` at the end
    std::vector<NameId> names_;
};

}  // namespace candelabra
