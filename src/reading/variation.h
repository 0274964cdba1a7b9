// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the parts of an object's block that vary between passes of a loop: the leading values of
// its shape, the colour of its only pigment, and the transformations at its end. A block is
// analysed once, and its variation is computed in each pass. Used by ShapePlan.
#pragma once

#include "base/colour.h"
#include "base/transform.h"
#include "interpret/evaluator.h"

#include <array>
#include <optional>

namespace candelabra {

/// The varying values of one pass.
struct Variation {
    static constexpr std::size_t most = 6;

    std::array<Numbers, most> values;  ///< the leading values of the shape
    std::size_t count = 0;
    Colour colour;                      ///< colour of the only pigment
    std::optional<Transform> movement;  ///< transformation at the end of the block
};

/// The places of the varying values in a block.
class Variable {
public:
    /// Analyses the block. Returns nothing if anything else may vary, or if a varying part may
    /// change its meaning. `values` is the number of values that the shape needs.
    static std::optional<Variable> find(Evaluator&, const Body& block, std::size_t values);

    bool coloured() const { return colour_ != no_node; }
    bool moved() const { return movements_ != no_node; }
    /// Whether only the values vary.
    bool plain() const { return !coloured() && !moved(); }
    /// The names on which the invariant rest of the block depends.
    const std::vector<NameId>& names() const { return names_; }

    /// Computes the current values into a new Variation; returns false for anything unusual. This
    /// may draw random numbers, so the caller makes it an attempt of the evaluator.
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
