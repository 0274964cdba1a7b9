// SPDX-License-Identifier: GPL-3.0-or-later
// What operands with signs between them amount to, when they come one by one because directives
// stand between them: products before sums. Used for values and for what functions compile to.
#pragma once

#include "syntax/tree.h"

#include <optional>
#include <utility>

namespace candelabra {

template <class Operand>
class ChainTotal {
public:
    /// The first operand; each other one comes with the sign in front of it, and `join(sign, a, b)`
    /// computes.
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

    /// Nothing when nothing has come.
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
    std::optional<Operand> product_;  ///< of the last operands
    Operator sign_ = Operator::add;   ///< in front of it
};

}  // namespace candelabra
