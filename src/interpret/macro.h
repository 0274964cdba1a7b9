// SPDX-License-Identifier: GPL-3.0-or-later
// What `#macro` declares: its parameters, and where its body is in which tree. The trees live as
// long as the evaluation.
#pragma once

#include "syntax/tree.h"

#include <vector>

namespace candelabra {

struct MacroData {
    struct Parameter {
        NameId name;
        bool optional;
    };

    NameId name;
    std::vector<Parameter> parameters;
    std::size_t least = 0;  ///< how many arguments it needs
    Body body;
    Span defined;  ///< from `#macro` to its name
};

}  // namespace candelabra
