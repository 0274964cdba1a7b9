// SPDX-License-Identifier: GPL-3.0-or-later
// Values and items as the language writes them: for the manual's defaults and for dumps that can be
// read back.
#pragma once

#include "base/function_ref.h"
#include "vocabulary/schema.h"

#include <string>

namespace candelabra {

/// The value as a scene would give it, numbers in the fewest digits that read back as the same.
/// Equal components are written as one number, as the language allows. Nothing is written as "".
std::string written(const FieldValue&, FieldType);

/// The texture of that number among those that the parts of an object name.
using WrittenLook = FunctionRef<std::string(int number)>;

/// The fields of an item, without its name: the positional ones, then those that differ from their
/// defaults, on one line. Parts in blocks have their textures only where `look` tells them.
std::string written_fields(const ItemInfo&, const void* item);
std::string written_fields(const ItemInfo&, const void* item, WrittenLook look);

}  // namespace candelabra
