// SPDX-License-Identifier: GPL-3.0-or-later
// The total of operands with operators between them, products before sums. Operands are added one
// by one, because directives may stand between them. Used for values and for compiled functions.
#pragma once

#include "syntax/tree.h"

#include <optional>
#include <utility>

namespace candelabra {

template <class Operand>
class ChainTotal {
public:
    /// Adds an operand with the operator before it, which does not count for the first.
    /// `join(sign, a, b)` computes.
    template <class Join>
    void add(Operator sign, Operand operand, Join join) {
        if (product_ && (sign == Operator::multiply || sign == Operator::divide)) {
            product_ = join(sign, std::move(*product_), std::move(operand));
            return;
        }
        end_product(join);
        product_ = std::move(operand);
        sign_ = sign;
    }

    /// The total; nothing without operands.
    template <class Join>
    std::optional<Operand> result(Join join) {
        end_product(join);
        return std::move(sum_);
    }

private:
    template <class Join>
    void end_product(Join join) {
        if (!product_) return;
        sum_ = sum_ ? join(sign_, std::move(*sum_), std::move(*product_)) : std::move(*product_);
        product_.reset();
    }

    std::optional<Operand> sum_;
    std::optional<Operand> product_;  ///< product of the last operands
    Operator sign_ = Operator::add;   ///< operator before the product
};

}  // namespace candelabra
