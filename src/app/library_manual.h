// SPDX-License-Identifier: GPL-3.0-or-later
// The standard library as a part of the manual: its files in order, each with its description and
// the macros that are meant for scenes.
#pragma once

#include "editor/library_guide.h"
#include "vocabulary/manual.h"

#include <string>

namespace candelabra {

/// Returns the form of a call of the macro in that file, and its help text.
ManualEntry manual_entry(const LibraryMacro&, std::string_view file);

/// Roff output has a section for each file; JSON output is a list of files with their macros.
std::string library_manual(const LibraryGuide&, ManualForm);

}  // namespace candelabra
