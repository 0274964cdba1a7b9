// SPDX-License-Identifier: GPL-3.0-or-later
// The functions that expressions can call: one table with name, number of arguments, help and code.
// Functions of names rather than values (defined) are with the expressions; functions of objects
// come from the binder.
#pragma once

#include "base/function_ref.h"
#include "interpret/object_queries.h"
#include "interpret/value.h"
#include "text/diagnostic.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace candelabra {

class Evaluator;

/// POV-Ray's random numbers: seed() opens a stream, rand() advances one.
class RandomStreams {
public:
    /// Opens a stream and returns its number.
    std::size_t open(double seed);
    bool known(double stream) const {
        return stream >= 0 && stream < static_cast<double>(states_.size());
    }
    /// The next number of a known stream, from 0 to 1, both included.
    double next(std::size_t stream) {
        std::uint32_t& state = states_[stream];
        state = state * 1812433253u + 12345u;
        return state / 4294967295.0;
    }

    // For attempts that may be undone. An attempt may contain others; then it must be ended.
    /// Returns the start of the attempt, for take_back().
    std::size_t begin_attempt(bool contains_others = false) {
        if (!inside_) drawn_.clear();
        inside_ = inside_ || contains_others;
        return drawn_.size();
    }
    void end_attempt() { inside_ = false; }
    /// next(), within an attempt.
    double attempt(std::size_t stream) {
        drawn_.push_back({stream, states_[stream]});
        return next(stream);
    }
    /// Restores all streams to their states at the start of the attempt.
    void take_back(std::size_t begin);

private:
    struct Drawn {
        std::size_t stream;
        std::uint32_t before;
    };

    std::vector<std::uint32_t> states_;
    std::vector<Drawn> drawn_;
    bool inside_ = false;  ///< within an attempt that contains others
};

/// State that functions can see and change besides their arguments.
struct FunctionWorld {
    Evaluator* evaluator = nullptr;
    RandomStreams random;
    std::function<bool(std::string_view)> file_exists;
    std::function<void(Diagnostic)> report;
    ObjectQueries* objects = nullptr;  ///< null: there are none
};

/// A call with its arguments computed. The accessors report an argument of the wrong kind once.
/// Then the result of the call is discarded, so the value that they return does not matter.
class FunctionCall {
public:
    FunctionCall(std::string_view name, std::span<const Value> arguments,
                 std::span<const Span> places, Span span, FunctionWorld& world)
        : world(world), name_(name), arguments_(arguments), places_(places), span_(span) {}

    std::size_t count() const { return arguments_.size(); }
    double number(std::size_t i);
    /// Truncates towards zero. A number out of range becomes the nearest in range.
    std::int64_t integer(std::size_t i);
    Vec3 vector(std::size_t i);
    const Numbers& numbers(std::size_t i);
    std::string_view text(std::size_t i);
    const ArrayData* array(std::size_t i);
    const Value& value(std::size_t i) const { return arguments_[i]; }
    /// Null after a report.
    Handle<Object> object(std::size_t i);
    /// Sets a second result, for the variable that the last argument names.
    void give(Value value) { given_ = std::move(value); }
    const std::optional<Value>& given() const { return given_; }

    Value fail(Fault, std::size_t argument, std::string message);
    void warn(Fault, std::size_t argument, std::string message);
    /// The same after the problem has been reported.
    Value fail_silently();
    bool failed() const { return failed_; }
    /// The place of an argument.
    Span place(std::size_t argument) const {
        return argument < places_.size() ? places_[argument] : span_;
    }

    FunctionWorld& world;

private:
    Value wrong_kind(std::size_t i, std::string_view wanted);

    std::string_view name_;
    std::span<const Value> arguments_;
    std::span<const Span> places_;
    Span span_;
    std::optional<Value> given_;
    bool failed_ = false;
};

struct FunctionInfo {
    using Unary = double (*)(double);
    using General = Value (*)(FunctionCall&);
    static constexpr int any = 1000;

    std::string_view name;
    int least, most;  ///< number of arguments
    std::string_view arguments;
    std::string_view help;
    std::variant<Unary, General> code;
    /// A call with its value, `abs(-2) -> 2`, or statements with a call. Help, editors and the
    /// manual show it, and tests/manual/examples_test.cpp runs it beside lamps.csv and lamps.json.
    std::string_view example;
};

/// The functions of values, sorted by name.
std::span<const FunctionInfo> functions();

}  // namespace candelabra
