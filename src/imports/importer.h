// SPDX-License-Identifier: GPL-3.0-or-later
// Reads models by Assimp. Private to this module.
#pragma once

#include "imports/imported_model.h"

namespace candelabra {

/// As Imports::read. Throws if memory does not suffice.
std::string import_model(std::string_view name, std::string_view bytes, const BesideModel&,
                         ImportedModel&);

}  // namespace candelabra
