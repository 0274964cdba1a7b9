// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that read files of data into arrays. The table in functions.cpp names and describes
// them.
#pragma once

#include "interpret/functions.h"

namespace candelabra {

Value csv_file(FunctionCall&);
Value json_file(FunctionCall&);
Value column_names(FunctionCall&);
Value find_column(FunctionCall&);

}  // namespace candelabra
