// SPDX-License-Identifier: GPL-3.0-or-later
// A tree as it is, a node a line, for `--dump tree` and for comparing trees. Places are left out.
// Does not recurse, so trees of any depth can be written.
#pragma once

#include "syntax/tree.h"

#include <string>

std::string dump(const Tree&, const Names&);
