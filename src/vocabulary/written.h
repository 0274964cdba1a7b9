// SPDX-License-Identifier: GPL-3.0-or-later
// Writes values and items in the syntax of the language, for the manual's defaults and for dumps
// that can be read back.
#pragma once

#include "base/function_ref.h"
#include "vocabulary/schema.h"

#include <string>

namespace candelabra {

class Transform;

/// A function is written as its address between these, because this module does not know functions;
/// see scene/dump_function.h. No other text has these characters.
inline constexpr char function_begin = '\3', function_end = '\4';

/// ` matrix <...>` with the same bits in both directions when it is read again: it has 12 numbers,
/// and those of the inverse behind them where these do not follow from the first. Empty for the
/// identity.
std::string matrix_text(const Transform&);

/// The value as a scene would give it, with the fewest digits that read back the same. Equal
/// components are written as one number, as the language allows. An unset value is written as "".
std::string written(const FieldValue&, FieldType);

/// Writes the texture with that number in the object's list of part textures.
using WrittenLook = FunctionRef<std::string(int number)>;

/// Writes the fields of an item without its name, on one line: the positional ones, then those that
/// differ from their defaults. Textures of parts in blocks are written by `look`.
std::string written_fields(const ItemInfo&, const void* item);
std::string written_fields(const ItemInfo&, const void* item, WrittenLook look);

}  // namespace candelabra
