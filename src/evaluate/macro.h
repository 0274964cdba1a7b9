// SPDX-License-Identifier: GPL-3.0-or-later
// What `#macro` declares: where its parameters and its body are in which tree. The trees live as
// long as the evaluation.
#pragma once

#include "syntax/tree.h"

struct MacroData {
    NameId name;
    Body parameters;
    Body body;
    Span defined;
};
