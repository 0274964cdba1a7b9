// SPDX-License-Identifier: GPL-3.0-or-later
// A model as one string of bytes, on its way from the process that reads it. The string is not
// trusted, since what the process has read may have broken it. Called by model_import.cpp.
#pragma once

#include "imports/imported_model.h"

namespace candelabra {

std::string packed(const ImportedModel&);

/// Reads what packed() has made. Returns an error as a sentence, or, with a complete result, an
/// empty string. In the result, each index is one of an entry or below 0, each number of a mesh is
/// finite, and parents come before their children.
std::string unpack(std::string_view bytes, ImportedModel&);

}  // namespace candelabra
