// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/tree.h"

namespace candelabra {

std::string_view spelling(Operator sign) {
    constexpr std::string_view signs[] = {
        "+", "-", "*", "/", "<", "<=", "=", "!=", ">=", ">", "&", "|", "+", "-", "!"};
    return signs[static_cast<std::size_t>(sign)];
}

}  // namespace candelabra
