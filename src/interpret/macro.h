// SPDX-License-Identifier: GPL-3.0-or-later
// The value that `#macro` declares: its parameters, and the place of its body in a tree. Trees live
// as long as the evaluation.
#pragma once

#include "interpret/macro_contract.h"

#include <vector>

namespace candelabra {

struct MacroData {
    struct Parameter {
        NameId name;
        bool optional;
        MacroContract contract;
    };

    NameId name;
    std::vector<Parameter> parameters;
    std::size_t least = 0;  ///< minimum number of arguments
    bool has_contracts = false;
    Body body;
    Span defined;  ///< from `#macro` to its name
};

}  // namespace candelabra
