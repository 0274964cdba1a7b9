// SPDX-License-Identifier: GPL-3.0-or-later
// A short text that the file system keeps with a file, beside its content. Used to recognise the
// files that a scene has made.
#pragma once

#include "text/opened_file.h"

#include <string>

namespace candelabra {

/// Returns the mark of the file, which need not be open for reading; "" if it has none.
std::string mark_of(const OpenedFile&);

/// Marks a file that is open for writing. Returns false if its file system keeps no marks.
bool set_mark(const OpenedFile&, const std::string& mark);

}  // namespace candelabra
