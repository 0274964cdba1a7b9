// SPDX-License-Identifier: GPL-3.0-or-later
// What a macro's parameter accepts, as its `#macro` states it: `Lamp object or array[]`,
// `Count whole >= 1`, `Share >= 0 <= 1`.
#pragma once

#include "interpret/value.h"
#include "syntax/tree.h"
#include "text/diagnostic.h"

#include <string>
#include <vector>

namespace candelabra {

class MacroContract {
public:
    /// A bound of a call: its number, and what the contract calls it (empty for a number).
    struct Limit {
        Operator sign;
        double value;
        std::string name;
    };

    /// Reads the nodes of a parameter. A kind that does not exist, and bounds of a value that has
    /// none, are reported.
    static MacroContract read(const Tree& tree, NodeId first, const Names& names,
                              Diagnostics& diagnostics);

    /// Whether every value is accepted.
    bool empty() const { return kinds_.empty() && bounds_.empty(); }
    /// The nodes of the bounds: numbers, constants and names, which may be those of parameters.
    const std::vector<node::Bound>& bounds() const { return bounds_; }

    /// Returns what is wrong with a value, as "a whole number of at least 1, but it is 2.5"; empty
    /// if it is accepted. `limits` are the bounds with their numbers, in their order.
    std::string refusal(const Value& value, const std::vector<Limit>& limits) const;

private:
    struct Kind {
        /// Numbers of one component, numbers of any, or a kind of shared value.
        enum class Of : std::uint8_t { number, vector, other } of;
        std::string name;          ///< with its article
        std::uint32_t dimensions;  ///< of an array; 0: any
    };

    const Kind* kind_of(const Value& value) const;
    std::string expected(const std::vector<Limit>& limits) const;
    bool within(const Value& value, const std::vector<Limit>& limits) const;

    std::vector<Kind> kinds_;
    std::vector<node::Bound> bounds_;
    bool whole_ = false;
};

}  // namespace candelabra
