// SPDX-License-Identifier: GPL-3.0-or-later
// Values of expressions and names: numbers, strings, arrays, and shared immutable parts of a scene.
// An absent value states the reason, so that nothing is reported twice. There is no conversion to
// bool.
#pragma once

#include "base/colour.h"
#include "base/handle.h"
#include "base/vector.h"
#include "text/span.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace candelabra {

class ArrayData;
class Formula;
class Spline;
class Transform;
struct DataFile;
struct MacroData;
struct Object;

/// One to five numbers: a float, a vector, or with five a colour (red, green, blue, filter,
/// transmit).
struct Numbers {
    std::array<double, 5> at{};
    int count = 1;

    static Numbers scalar(double value) { return {{value}, 1}; }
    static Numbers vector(const Vec3& v) { return {{v.x, v.y, v.z}, 3}; }
    static Numbers colour(const Colour& c) {
        return {{c.rgb.r, c.rgb.g, c.rgb.b, c.filter, c.transmit}, 5};
    }

    bool is_scalar() const { return count == 1; }
    bool is_colour() const { return count == 5; }
    /// With at least n components: one number is copied to all, others get zeros.
    Numbers promoted(int n) const;
    Vec3 vec3() const { return {at[0], at[1], at[2]}; }
    Colour to_colour() const { return {{at[0], at[1], at[2]}, at[3], at[4]}; }

    friend bool operator==(const Numbers&, const Numbers&) = default;
};

enum class Absence : std::uint8_t {
    nothing,        ///< no value was given, e.g. by a macro without elements
    uninitialised,  ///< an array's element that was never set
    broken,         ///< has been reported: needs no further report
};

/// A kind of shared value. Its address identifies it.
struct ValueKind {
    std::string (*name)();  ///< for messages: "a string"
};

/// "an open file" for "open_file".
std::string with_article(std::string_view word);

/// The name of a type in messages. The type of an item has its name in its vocabulary; other names
/// are stated here, or where the type is defined.
template <class T>
struct KindName {
    static std::string text() { return with_article(T::vocabulary.name); }
};

/// A name that is stated where the type is defined.
template <std::size_t size>
struct KindText {
    consteval KindText(const char (&written)[size]) { std::copy_n(written, size, text); }
    char text[size]{};
};
template <KindText name>
struct Named {
    static std::string text() { return name.text; }
};
template <>
struct KindName<std::string> : Named<"a string"> {};
template <>
struct KindName<ArrayData> : Named<"an array"> {};
template <>
struct KindName<Formula> : Named<"a function"> {};
template <>
struct KindName<Object> : Named<"an object"> {};
template <>
struct KindName<Transform> : Named<"a transform"> {};
template <>
struct KindName<DataFile> : Named<"an open file"> {};
template <>
struct KindName<Spline> : Named<"a spline"> {};

template <class T>
inline constexpr ValueKind value_kind{&KindName<T>::text};

/// A hand-written variant: most values copied and moved are numbers, which must not cost a
/// dispatch.
class Value {
public:
    Value(Absence why) : kind_(absence_kind), absence_(why) {}
    Value(double number) : kind_(numbers_kind), numbers_(Numbers::scalar(number)) {}
    Value(const Numbers& numbers) : kind_(numbers_kind), numbers_(numbers) {}
    Value(std::string text) : Value(make_handle<std::string>(std::move(text))) {}
    template <class T>
    Value(Handle<T> handle)
        : kind_(byte_of<T>), shared_{AnyHandle(std::move(handle)), &value_kind<T>} {}
    /// Macros live as long as the evaluation.
    Value(const MacroData* macro) : kind_(macro_kind), macro_(macro) {}

    Value(const Value& other) : kind_(other.kind_) {
        if (is_shared())
            new (&shared_) Shared(other.shared_);
        else
            take_plain(other);
    }
    Value(Value&& other) noexcept : kind_(other.kind_) {
        if (is_shared())
            new (&shared_) Shared(std::move(other.shared_));
        else
            take_plain(other);
    }
    Value& operator=(const Value& other) {
        if (this != &other) *this = Value(other);
        return *this;
    }
    Value& operator=(Value&& other) noexcept {
        if (this == &other) return *this;
        this->~Value();
        return *new (this) Value(std::move(other));
    }
    ~Value() {
        if (is_shared()) shared_.~Shared();
    }

    explicit operator bool() const = delete;

    const Numbers* numbers() const { return kind_ == numbers_kind ? &numbers_ : nullptr; }
    Numbers* edit_numbers() { return kind_ == numbers_kind ? &numbers_ : nullptr; }
    /// The string, or null.
    const std::string* text() const { return shared<std::string>(); }
    /// The string for writing, when no other value shares it; otherwise null.
    std::string* own_text();
    const ArrayData* array() const { return shared<ArrayData>(); }
    /// The array for writing. A shared array is copied first, so that no other value sees the
    /// change. Precondition: array().
    ArrayData& edit_array();
    /// Whether no other value has the same array. Precondition: array().
    bool alone() const { return shared_.handle.alone(); }
    const MacroData* macro() const { return kind_ == macro_kind ? macro_ : nullptr; }
    const Formula* formula() const { return shared<Formula>(); }
    /// The address of the shared part, to test whether it is still the same; null for values that
    /// are not shared.
    const void* shared_place() const { return is_shared() ? shared_.handle.get() : nullptr; }
    /// The shared part of a scene, or null when the value is something else.
    template <class T>
    Handle<T> handle() const {
        return holds<T>() ? shared_.handle.as<T>() : Handle<T>();
    }
    bool absent() const { return kind_ == absence_kind; }
    /// Whether it has been reported, so that no further report is needed.
    bool broken() const { return is(Absence::broken); }
    bool is(Absence why) const { return kind_ == absence_kind && absence_ == why; }
    /// Whether both are the same thing: equal numbers, or one shared part.
    bool identical(const Value& other) const {
        if (kind_ != other.kind_) return false;
        if (is_shared())
            return shared_.kind == other.shared_.kind &&
                   shared_.handle.get() == other.shared_.handle.get();
        if (kind_ == numbers_kind) return numbers_ == other.numbers_;
        return kind_ == macro_kind ? macro_ == other.macro_ : absence_ == other.absence_;
    }
    /// Whether both are of the same kind; all numbers are one kind.
    bool same_kind(const Value& other) const {
        return kind_ == other.kind_ && (!is_shared() || shared_.kind == other.shared_.kind);
    }

private:
    static constexpr std::uint8_t absence_kind = 0, numbers_kind = 1, macro_kind = 2,
                                  shared_kind = 3, array_kind = 4, object_kind = 5;
    /// Shared values have greater bytes than others. The kinds that loops ask for most have bytes
    /// of their own, so that one comparison suffices.
    template <class T>
    static constexpr std::uint8_t byte_of = std::is_same_v<T, ArrayData> ? array_kind
                                            : std::is_same_v<T, Object>  ? object_kind
                                                                         : shared_kind;
    bool is_shared() const { return kind_ >= shared_kind; }
    struct Shared {
        AnyHandle handle;
        const ValueKind* kind;
    };

    template <class T>
    bool holds() const {
        return kind_ == byte_of<T> && (byte_of<T> != shared_kind || shared_.kind == &value_kind<T>);
    }
    template <class T>
    const T* shared() const {
        return holds<T>() ? static_cast<const T*>(shared_.handle.get()) : nullptr;
    }
    void take_plain(const Value& other) {
        if (kind_ == numbers_kind)
            numbers_ = other.numbers_;
        else if (kind_ == macro_kind)
            macro_ = other.macro_;
        else
            absence_ = other.absence_;
    }

    std::uint8_t kind_;
    union {
        Absence absence_;
        Numbers numbers_;
        const MacroData* macro_;
        Shared shared_;
    };

    friend std::string kind_name(const Value&);
};
static_assert(sizeof(Value) <= 56);

/// The kind of a value, for messages: "a number", "a vector of 3", "a colour", "a string", "a
/// pigment", ...
std::string kind_name(const Value&);
/// The same, with the start of a string: "the string \"north\"". For values from tables, where the
/// text identifies the value.
std::string kind_and_text(const Value&);

}  // namespace candelabra
