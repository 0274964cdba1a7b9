// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/value.h"

#include "interpret/array_data.h"

Numbers Numbers::promoted(int n) const {
    Numbers result = *this;
    if (n <= count) return result;
    for (int i = count; i < n; ++i) result.at[static_cast<std::size_t>(i)] = count == 1 ? at[0] : 0;
    result.count = n;
    return result;
}

std::string* Value::own_text() {
    return kind_ == kind_of<std::string> && shared_.alone() ? &shared_.edit<std::string>()
                                                            : nullptr;
}

ArrayData& Value::edit_array() { return shared_.edit<ArrayData>(); }

std::string_view kind_name(const Value& value) {
    constexpr auto numbers = std::array<std::string_view, 5>{
        "a number", "a vector of 2", "a vector of 3", "a vector of 4", "a colour"};
    constexpr auto shared = std::to_array<std::string_view>(
        {"a string",       "an array",     "a function",   "an object",     "a texture",
         "a pigment",      "a finish",     "an interior",  "a transform",   "a camera",
         "a light source", "a colour map", "an open file", "a pigment map", "a normal",
         "a normal map",   "a slope map",  "a spline",     "a texture map", "a material",
         "a sky sphere",   "a fog",        "a rainbow"});
    static_assert(shared.size() == ValueKinds::count);
    if (const Numbers* found = value.numbers())
        return numbers[static_cast<std::size_t>(found->count) - 1];
    if (value.absent()) return "nothing";
    if (value.macro()) return "a macro";
    return shared[value.kind_ - Value::first_shared];
}
