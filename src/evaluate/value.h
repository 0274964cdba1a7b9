// SPDX-License-Identifier: GPL-3.0-or-later
// What expressions and names of the language stand for: numbers, strings, arrays, and shared
// immutable parts of a scene. A value that is not there says why, so that nobody reports the same
// hole twice. There is no conversion to bool.
#pragma once

#include "base/colour.h"
#include "base/handle.h"
#include "base/vector.h"
#include "text/span.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

struct ColourStop;
struct DataFile;
struct DeclaredCamera;
struct Finish;
struct Interior;
struct Object;
struct Pigment;
struct PlacedLight;
struct Texture;
class Transform;

/// One to five numbers: a float, a vector, or with five a colour (red, green, blue, filter,
/// transmit).
struct Numbers {
    std::array<double, 5> at{};
    int count = 1;

    static Numbers scalar(double value) { return {{value}, 1}; }
    static Numbers vector(const Vec3& v) { return {{v.x, v.y, v.z}, 3}; }
    static Numbers colour(const Colour& c) {
        return {{c.rgb.x, c.rgb.y, c.rgb.z, c.filter, c.transmit}, 5};
    }

    bool is_scalar() const { return count == 1; }
    bool is_colour() const { return count == 5; }
    /// With at least n components: one number is copied to all, others get zeros.
    Numbers promoted(int n) const;
    Vec3 vec3() const { return {at[0], at[1], at[2]}; }
    Colour to_colour() const { return {vec3(), at[3], at[4]}; }

    friend bool operator==(const Numbers&, const Numbers&) = default;
};

enum class Absence : std::uint8_t {
    nothing,        ///< there was nothing to give a value, e.g. a macro without elements
    uninitialised,  ///< an array's element that was never set
    broken,         ///< has been reported: say no more
};

class Value;

/// An array of up to five dimensions, all elements of one kind. Copied when it is written to while
/// shared.
struct ArrayData {
    std::vector<int> sizes;
    std::vector<Value> elements;  ///< the last index runs fastest
};

struct MacroData;

class Value {
public:
    using Content =
        std::variant<Absence, Numbers, Handle<std::string>, std::shared_ptr<ArrayData>,
                     Handle<MacroData>, Handle<Object>, Handle<Texture>, Handle<Pigment>,
                     Handle<Finish>, Handle<Interior>, Handle<Transform>, Handle<DeclaredCamera>,
                     Handle<PlacedLight>, Handle<std::vector<ColourStop>>, Handle<DataFile>>;

    Value(Absence why) : content_(why) {}
    Value(double number) : content_(Numbers::scalar(number)) {}
    Value(const Numbers& numbers) : content_(numbers) {}
    Value(std::string text) : content_(make_handle<std::string>(std::move(text))) {}
    template <class T>
    Value(Handle<T> handle) : content_(std::move(handle)) {}
    Value(std::shared_ptr<ArrayData> array) : content_(std::move(array)) {}

    explicit operator bool() const = delete;

    const Numbers* numbers() const { return std::get_if<Numbers>(&content_); }
    /// The string, or null.
    const std::string* text() const;
    const ArrayData* array() const;
    /// The array for writing: no other value sees the change. Precondition: array().
    ArrayData& edit_array();
    /// The shared part of a scene, or null when the value is something else.
    template <class T>
    Handle<T> handle() const {
        const auto* found = std::get_if<Handle<T>>(&content_);
        return found ? *found : Handle<T>();
    }
    bool absent() const { return std::holds_alternative<Absence>(content_); }
    /// Has been reported: nobody needs to hear of it again.
    bool broken() const { return is(Absence::broken); }
    bool is(Absence why) const {
        const auto* found = std::get_if<Absence>(&content_);
        return found && *found == why;
    }
    template <class F>
    decltype(auto) visit(F&& function) const {
        return std::visit(std::forward<F>(function), content_);
    }
    Numbers* edit_numbers() { return std::get_if<Numbers>(&content_); }
    /// Whether both are of the same kind; all numbers are one kind.
    bool same_kind(const Value& other) const { return content_.index() == other.content_.index(); }

private:
    Content content_;
};
static_assert(sizeof(Value) <= 56);

/// What a value is, for messages: "a number", "a vector of 3", "a colour", "a string", "a pigment",
/// ...
std::string_view kind_name(const Value&);
