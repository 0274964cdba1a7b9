// SPDX-License-Identifier: GPL-3.0-or-later
// Values and items as the language writes them: for the manual's defaults and for dumps that can be
// read back.
#pragma once

#include "vocabulary/schema.h"

#include <string>

/// The value as a scene would give it, numbers in the fewest digits that read back as the same.
/// Equal components are written as one number, as the language allows. Nothing is written as "".
std::string written(const FieldValue&, FieldType);

/// The fields of an item, without its name: the positional ones, then those that differ from their
/// defaults, on one line.
std::string written_fields(const ItemInfo&, const void* item);
