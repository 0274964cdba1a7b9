// SPDX-License-Identifier: GPL-3.0-or-later
// A tree as text that parses to the same tree, comments and layout aside. Does not recurse, so
// trees of any depth can be written.
#pragma once

#include "syntax/tree.h"

#include <string>

namespace candelabra {

std::string print(const Tree&, const Names&);

}  // namespace candelabra
