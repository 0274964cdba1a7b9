// SPDX-License-Identifier: GPL-3.0-or-later
// Values of the language as values of fields. Called by the readers of blocks; says what a value
// must be when it is not.
#pragma once

#include "bind/block.h"

#include <optional>

namespace candelabra {

/// The place of a value, for messages.
struct Slot {
    FunctionRef<std::string()> name;
    FunctionRef<std::string()> help;
};

/// The value as a field of the type has it, in the way of POV-Ray: one number serves for all
/// components, missing ones are 0. Nothing, after a report, when it is something else.
std::optional<FieldValue> converted(OpenBlock&, const Element&, FieldType, const Slot&);

/// Sets a field of the item to numbers that are surely right for it and in its range. False:
/// nothing has happened, and converted() must say why, or do more.
bool set_fitting(const ItemInfo&, void* item, std::size_t field, const Numbers&);

/// A colour that must be said to be one: `rgb <1, 0, 0>`, `Red`, not <1, 0, 0>.
std::optional<Colour> plain_colour(OpenBlock&, const Element&);

/// Whether a body is nothing but `rgb ...`, as that of most pigments.
bool colour_alone(Body);
/// Its colour when it can be computed without saying anything; nothing has happened otherwise.
/// Precondition: colour_alone().
std::optional<Colour> computed_colour(Evaluator&, Body);

/// What a value of the type is called: "a whole number".
std::string_view kind_name(FieldType);

/// The component that is out of range, or null.
const double* offender(const Range&, const FieldValue&);
/// What the range asks for: "at least 0".
std::string rule(const Range&);

}  // namespace candelabra
