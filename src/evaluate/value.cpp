// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/value.h"

Numbers Numbers::promoted(int n) const {
    Numbers result = *this;
    if (n <= count) return result;
    for (int i = count; i < n; ++i) result.at[static_cast<std::size_t>(i)] = count == 1 ? at[0] : 0;
    result.count = n;
    return result;
}

const std::string* Value::text() const {
    const auto* found = std::get_if<Handle<std::string>>(&content_);
    return found ? found->get() : nullptr;
}

const ArrayData* Value::array() const {
    const auto* found = std::get_if<std::shared_ptr<ArrayData>>(&content_);
    return found ? found->get() : nullptr;
}

ArrayData& Value::edit_array() {
    auto& array = *std::get_if<std::shared_ptr<ArrayData>>(&content_);
    if (array.use_count() > 1) array = std::make_shared<ArrayData>(*array);
    return *array;
}

namespace {

struct KindName {
    std::string_view operator()(Absence) const { return "nothing"; }
    std::string_view operator()(const Numbers& numbers) const {
        constexpr std::string_view names[] = {"a number", "a vector of 2", "a vector of 3",
                                              "a vector of 4", "a colour"};
        return names[numbers.count - 1];
    }
    std::string_view operator()(const Handle<std::string>&) const { return "a string"; }
    std::string_view operator()(const std::shared_ptr<ArrayData>&) const { return "an array"; }
    std::string_view operator()(const Handle<MacroData>&) const { return "a macro"; }
    std::string_view operator()(const Handle<Object>&) const { return "an object"; }
    std::string_view operator()(const Handle<Texture>&) const { return "a texture"; }
    std::string_view operator()(const Handle<Pigment>&) const { return "a pigment"; }
    std::string_view operator()(const Handle<Finish>&) const { return "a finish"; }
    std::string_view operator()(const Handle<Interior>&) const { return "an interior"; }
    std::string_view operator()(const Handle<Transform>&) const { return "a transform"; }
    std::string_view operator()(const Handle<DeclaredCamera>&) const { return "a camera"; }
    std::string_view operator()(const Handle<PlacedLight>&) const { return "a light source"; }
    std::string_view operator()(const Handle<std::vector<ColourStop>>&) const {
        return "a colour map";
    }
    std::string_view operator()(const Handle<DataFile>&) const { return "an open file"; }
};

}  // namespace

std::string_view kind_name(const Value& value) { return value.visit(KindName()); }
