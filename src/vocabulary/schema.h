// SPDX-License-Identifier: GPL-3.0-or-later
// How an item's .cpp file states its typed vocabulary, which described() makes untyped.
#pragma once

#include "base/rgb.h"
#include "base/shared.h"
#include "vocabulary/field.h"
#include "vocabulary/parts.h"
#include "vocabulary/reserved.h"

#include <span>
#include <type_traits>

namespace candelabra {

/// One sentence of help on an item, and examples of it, the simplest first. An example is written
/// as examples.h states.
struct ItemText {
    static constexpr std::size_t most = 20;

    template <class... Example>
    consteval ItemText(const char* text, Example... example)
        : help(text), examples{example...}, count(sizeof...(example)) {}

    std::string_view help;
    std::array<std::string_view, most> examples;
    std::size_t count;
};

template <class T, std::size_t N>
struct Schema {
    std::string_view name;
    ItemText text;
    std::array<Field<T>, N> fields;
};

/// The vocabulary of T: keyword, one sentence of help or `{help, example, ...}`, fields in the
/// order of their places.
template <class T, class... F>
consteval auto schema(std::string_view name, ItemText text, F... fields) {
    return Schema<T, sizeof...(F)>{name, text, {fields...}};
}

namespace schema_detail {

template <class V>
constexpr FieldType type_of() {
    if constexpr (std::is_same_v<V, double> || std::is_same_v<V, std::optional<double>>)
        return FieldType::number;
    else if constexpr (std::is_same_v<V, int> || std::is_same_v<V, std::optional<int>>)
        return FieldType::integer;
    else if constexpr (std::is_same_v<V, bool>)
        return FieldType::boolean;
    else if constexpr (std::is_same_v<V, Vec2> || std::is_same_v<V, std::optional<Vec2>>)
        return FieldType::vector2;
    else if constexpr (std::is_same_v<V, Vec3> || std::is_same_v<V, std::optional<Vec3>>)
        return FieldType::vector3;
    else if constexpr (std::is_same_v<V, Vec4>)
        return FieldType::vector4;
    else if constexpr (std::is_same_v<V, NoMember>)
        return FieldType::parts;
    else if constexpr (std::is_same_v<V, Rgb>)
        return FieldType::rgb;
    else if constexpr (std::is_same_v<V, Colour>)
        return FieldType::colour;
    else if constexpr (std::is_same_v<V, std::string>)
        return FieldType::text;
    else if constexpr (std::is_same_v<V, std::vector<double>>)
        return FieldType::numbers;
    else if constexpr (std::is_same_v<V, std::vector<Vec2>>)
        return FieldType::points;
    else if constexpr (std::is_same_v<V, std::vector<Vec3>>)
        return FieldType::vectors;
    else if constexpr (std::is_same_v<V, std::vector<Ball>>)
        return FieldType::balls;
    else if constexpr (std::is_same_v<V, Handle<Formula>>)
        return FieldType::function;
    else
        return FieldType::faces;
}

template <class V>
constexpr bool is_optional =
    std::is_same_v<V, std::optional<int>> || std::is_same_v<V, std::optional<double>> ||
    std::is_same_v<V, std::optional<Vec2>> || std::is_same_v<V, std::optional<Vec3>>;

/// A field whose member has the type V.
template <class V, class T>
constexpr FieldInfo describe(const Field<T>& field) {
    return {field.name,
            field.help,
            field.place,
            type_of<V>(),
            field.range,
            field.may_be_left_out || is_optional<V>,
            reserved_word(field.name),
            field.chosen,
            field.entries,
            field.parts};
}

template <class V>
void store(V& to, const FieldValue& value) {
    if constexpr (std::is_same_v<V, int> || std::is_same_v<V, std::optional<int>>)
        to = static_cast<int>(std::get<double>(value));
    else if constexpr (std::is_same_v<V, bool>)
        to = std::get<double>(value) > 0;
    else if constexpr (std::is_same_v<V, std::optional<double>>)
        to = std::get<double>(value);
    else if constexpr (std::is_same_v<V, std::optional<Vec2>>)
        to = std::get<Vec2>(value);
    else if constexpr (std::is_same_v<V, std::optional<Vec3>>)
        to = std::get<Vec3>(value);
    else if constexpr (std::is_same_v<V, Rgb>)
        to = rgb_of(std::get<Vec3>(value));
    else
        to = std::get<V>(value);
}

template <class V>
FieldValue load(const V& from) {
    if constexpr (std::is_same_v<V, int> || std::is_same_v<V, bool>)
        return static_cast<double>(from);
    else if constexpr (std::is_same_v<V, std::optional<int>>)
        return from ? FieldValue(static_cast<double>(*from)) : FieldValue();
    else if constexpr (is_optional<V>)
        return from ? FieldValue(*from) : FieldValue();
    else if constexpr (std::is_same_v<V, Rgb>)
        return vec3_of(from);
    else
        return from;
}

template <class T, class Make>
struct Access {
    static constexpr auto typed = Make()();
    template <std::size_t I>
    using Value = std::tuple_element_t<typed.fields[I].member.type(), MemberTypes>;
    static constexpr auto fields = []<std::size_t... I>(std::index_sequence<I...>) {
        return std::array<FieldInfo, sizeof...(I)>{describe<Value<I>>(typed.fields[I])...};
    }
    (std::make_index_sequence<typed.fields.size()>());
    using Setter = void (*)(T&, const FieldValue&);
    using Getter = FieldValue (*)(const T&);
    template <std::size_t... I>
    static constexpr std::array<Setter, sizeof...(I)> make_setters(std::index_sequence<I...>) {
        return {[](T& item, const FieldValue& value) { store_in<I>(item, value); }...};
    }
    template <std::size_t... I>
    static constexpr std::array<Getter, sizeof...(I)> make_getters(std::index_sequence<I...>) {
        return {[](const T& item) { return load_from<I>(item); }...};
    }
    /// One pair of functions for each field: no code is generated for types that T lacks, and no
    /// branch could read them.
    template <std::size_t I>
    static void store_in(T& item, const FieldValue& value) {
        if constexpr (!std::is_same_v<Value<I>, NoMember>)
            store(item.*typed.fields[I].member.template pointer<Value<I>>(), value);
    }
    template <std::size_t I>
    static FieldValue load_from(const T& item) {
        if constexpr (std::is_same_v<Value<I>, NoMember>)
            return {};
        else
            return load(item.*typed.fields[I].member.template pointer<Value<I>>());
    }
    static void set(void* item, std::size_t field, const FieldValue& value) {
        static constexpr auto setters =
            make_setters(std::make_index_sequence<typed.fields.size()>());
        setters[field](*static_cast<T*>(item), value);
    }
    static FieldValue get(const void* item, std::size_t field) {
        static constexpr auto getters =
            make_getters(std::make_index_sequence<typed.fields.size()>());
        return getters[field](*static_cast<const T*>(item));
    }
    static FieldValue default_value(std::size_t field) {
        const T fresh{};
        return get(&fresh, field);
    }
    static constexpr int positional = [] {
        int count = 0;
        while (count < static_cast<int>(fields.size()) &&
               fields[static_cast<std::size_t>(count)].unnamed())
            ++count;
        return count;
    }();
    static constexpr ItemInfo info{typed.name,
                                   typed.text.help,
                                   fields,
                                   set,
                                   get,
                                   default_value,
                                   reserved_word(typed.name),
                                   positional,
                                   {typed.text.examples.data(), typed.text.count}};
};

}  // namespace schema_detail

/// The vocabulary of T for readers that do not know T. `make` is a captureless lambda that returns
/// the schema.
template <class T, class Make>
consteval ItemInfo described(Make) {
    return schema_detail::Access<T, Make>::info;
}

}  // namespace candelabra
