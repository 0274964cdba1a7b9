// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/functions.h"

#include "base/degrees.h"
#include "base/elementary.h"
#include "interpret/array_data.h"
#include "interpret/data_functions.h"
#include "interpret/light_functions.h"
#include "interpret/number_functions.h"
#include "interpret/string_functions.h"
#include "text/message.h"

#include <array>
#include <cmath>

namespace candelabra {

std::size_t RandomStreams::open(double seed) {
    // Truncated to a signed 32-bit number. Numbers out of range become the least, as in POV-Ray.
    constexpr double least = -2147483648.0;
    const double whole = seed > least - 1 && seed < -least ? std::trunc(seed) : least;
    states_.push_back(static_cast<std::uint32_t>(static_cast<std::int32_t>(whole)));
    return states_.size() - 1;
}

void RandomStreams::take_back(std::size_t begin) {
    for (; drawn_.size() > begin; drawn_.pop_back())
        states_[drawn_.back().stream] = drawn_.back().before;
}

Value FunctionCall::fail(Fault fault, std::size_t argument, std::string message) {
    if (!failed_) world.report(error(fault, place(argument), std::move(message)));
    return fail_silently();
}

Value FunctionCall::fail_silently() {
    failed_ = true;
    return Absence::broken;
}

void FunctionCall::warn(Fault fault, std::size_t argument, std::string message) {
    world.report(warning(fault, place(argument), std::move(message)));
}

Value FunctionCall::wrong_kind(std::size_t i, std::string_view wanted) {
    return fail(
        Fault::wrong_type, i,
        message("`", name_, "` takes ", wanted, " here, but this is ", kind_name(arguments_[i])));
}

double FunctionCall::number(std::size_t i) {
    const Numbers* found = arguments_[i].numbers();
    if (found && found->is_scalar()) return found->at[0];
    wrong_kind(i, "a number");
    return 0;
}

std::int64_t FunctionCall::integer(std::size_t i) {
    const double value = number(i);
    if (std::isnan(value)) return 0;
    constexpr double limit = 9.2e18;
    return static_cast<std::int64_t>(value < -limit ? -limit : value > limit ? limit : value);
}

const Numbers& FunctionCall::numbers(std::size_t i) {
    static const Numbers nothing;
    if (const Numbers* found = arguments_[i].numbers()) return *found;
    wrong_kind(i, "numbers");
    return nothing;
}

Vec3 FunctionCall::vector(std::size_t i) {
    const Numbers& found = numbers(i);
    if (found.count <= 3) return found.promoted(3).vec3();
    wrong_kind(i, "a vector of 3");
    return Vec3(0);
}

std::string_view FunctionCall::text(std::size_t i) {
    if (const std::string* found = arguments_[i].text()) return *found;
    wrong_kind(i, "a string");
    return {};
}

Handle<Object> FunctionCall::object(std::size_t i) {
    Handle<Object> found = arguments_[i].handle<Object>();
    if (!found) wrong_kind(i, "a declared object");
    return found;
}

const ArrayData* FunctionCall::array(std::size_t i) {
    if (const ArrayData* found = arguments_[i].array()) return found;
    wrong_kind(i, "an array");
    return nullptr;
}

namespace {

using Call = FunctionCall&;
using General = FunctionInfo::General;
using Unary = FunctionInfo::Unary;

Value dimension_size(Call call) {
    const ArrayData* array = call.array(0);
    const double i = call.number(1);
    if (call.failed() || !(i >= 1 && i <= static_cast<double>(array->sizes().size()))) return 0.0;
    return array->sizes()[static_cast<std::size_t>(i) - 1];
}

Value dimensions(Call call) {
    const ArrayData* array = call.array(0);
    return array ? static_cast<double>(array->sizes().size()) : 0.0;
}

Value file_exists(Call call) { return call.world.file_exists(call.text(0)) ? 1.0 : 0.0; }

Value not_yet(Call call) {
    return call.fail(Fault::not_implemented, FunctionInfo::any,
                     "this function is known but not implemented");
}

constexpr auto table = std::array{
    FunctionInfo{"abs", 1, 1, "x", "x without its sign",
                 Unary([](double x) { return std::abs(x); }), "abs(-2) -> 2"},
    FunctionInfo{"acos", 1, 1, "x", "arc cosine, in radians", General(arc_cosine),
                 "acos(0) -> 1.570796"},
    FunctionInfo{"acosh", 1, 1, "x", "inverse hyperbolic cosine",
                 Unary([](double x) { return math::acosh(x); }), "acosh(1) -> 0"},
    FunctionInfo{"asc", 1, 1, "text", "code of the first character, 0 for none",
                 General(first_code), "asc(\"A\") -> 65"},
    FunctionInfo{"asin", 1, 1, "x", "arc sine, in radians", General(arc_sine),
                 "asin(1) -> 1.570796"},
    FunctionInfo{"asinh", 1, 1, "x", "inverse hyperbolic sine",
                 Unary([](double x) { return math::asinh(x); }), "asinh(0) -> 0"},
    FunctionInfo{"atan", 1, 1, "x", "arc tangent, in radians",
                 Unary([](double x) { return math::atan(x); }), "atan(1) -> 0.785398"},
    FunctionInfo{"atan2", 2, 2, "y, x", "angle of the point (x, y), in radians",
                 General(arc_tangent), "atan2(1, 0) -> 1.570796"},
    FunctionInfo{"atanh", 1, 1, "x", "inverse hyperbolic tangent",
                 Unary([](double x) { return math::atanh(x); }), "atanh(0) -> 0"},
    FunctionInfo{"bitwise_and", 1, FunctionInfo::any, "a, ...", "bits that all have",
                 General(bits_and), "bitwise_and(6, 3) -> 2"},
    FunctionInfo{"bitwise_or", 1, FunctionInfo::any, "a, ...", "bits that any has",
                 General(bits_or), "bitwise_or(6, 3) -> 7"},
    FunctionInfo{"bitwise_xor", 1, FunctionInfo::any, "a, ...", "bits that an odd number has",
                 General(bits_xor), "bitwise_xor(6, 3) -> 5"},
    FunctionInfo{"candela", 1, 1, "amount",
                 "luminous intensity as the colour that light falling with the square of the "
                 "distance has at 1: light_source { 2*y intensity candela(1000) }",
                 General(light_of_candela), "light_source { 2*y, rgb 1 intensity candela(1000) }"},
    FunctionInfo{"ceil", 1, 1, "x", "the next whole number, upwards",
                 Unary([](double x) { return std::ceil(x); }), "ceil(1.2) -> 2"},
    FunctionInfo{"chr", 1, 1, "code", "the character with this code", General(character),
                 "chr(65) -> \"A\""},
    FunctionInfo{"column_names", 1, 1, "array",
                 "the names in the header of a table, or of the members of an object: an array of "
                 "strings, empty where nothing has a name",
                 General(column_names), "#declare Names = column_names(read_csv(\"lamps.csv\"));"},
    FunctionInfo{"concat", 1, FunctionInfo::any, "text, ...", "the strings joined",
                 General(concatenated), "concat(\"a\", \"b\") -> \"ab\""},
    FunctionInfo{"cos", 1, 1, "x", "cosine of radians",
                 Unary([](double x) { return math::cos(x); }), "cos(pi) -> -1"},
    FunctionInfo{"cosh", 1, 1, "x", "hyperbolic cosine",
                 Unary([](double x) { return math::cosh(x); }), "cosh(0) -> 1"},
    FunctionInfo{"datetime", 1, 2, "days[, format]", "a date as text, in UTC; days count from 2000",
                 General(date_text), "datetime(0, \"%Y-%m-%d\") -> \"2000-01-01\""},
    FunctionInfo{"degrees", 1, 1, "x", "radians to degrees",
                 Unary([](double x) { return x / radians_per_degree; }), "degrees(pi) -> 180"},
    FunctionInfo{"dimension_size", 2, 2, "array, n", "size in dimension n, from 1",
                 General(dimension_size),
                 "#declare A = array[2][3]; #declare Columns = dimension_size(A, 2);"},
    FunctionInfo{"dimensions", 1, 1, "array", "number of dimensions", General(dimensions),
                 "#declare A = array[2][3]; #declare Depth = dimensions(A);"},
    FunctionInfo{"div", 2, 2, "a, b", "whole part of a / b", General(divide_whole),
                 "div(7, 2) -> 3"},
    FunctionInfo{"exp", 1, 1, "x", "e to the power of x",
                 Unary([](double x) { return math::exp(x); }), "exp(1) -> 2.718282"},
    FunctionInfo{"file_exists", 1, 1, "name", "whether the file can be read", General(file_exists),
                 "file_exists(\"lamps.csv\") -> 1"},
    FunctionInfo{
        "find_column", 2, 2, "array, name",
        "the number of the column that the header of a table calls so, -1: there is none",
        General(find_column),
        "#declare Lamps = read_csv(\"lamps.csv\"); #declare Height = find_column(Lamps, \"y\");"},
    FunctionInfo{"floor", 1, 1, "x", "the next whole number, downwards",
                 Unary([](double x) { return std::floor(x); }), "floor(-1.2) -> -2"},
    FunctionInfo{"int", 1, 1, "x", "x without its fraction", Unary(to_integer), "int(-1.7) -> -1"},
    FunctionInfo{"kelvin", 1, 2, "temperature[, locus]",
                 "colour of light, with luminance 1: of a glowing body, or with \"daylight\" of "
                 "daylight, whose white is 6504",
                 General(colour_of_kelvin), "light_source { 5*y, kelvin(2700) }"},
    FunctionInfo{"ln", 1, 1, "x", "natural logarithm", General(natural_logarithm),
                 "ln(exp(2)) -> 2"},
    FunctionInfo{"log", 1, 1, "x", "logarithm to base 10", General(decimal_logarithm),
                 "log(1000) -> 3"},
    FunctionInfo{"lumen", 1, 1, "amount",
                 "luminous flux as radiance times area: emission lumen(800) / area, or luminaire { "
                 "flux lumen(800) }",
                 General(light_of_lumens),
                 "sphere { y, 0.1 pigment { rgb 1 } luminaire { flux lumen(800) } }"},
    FunctionInfo{"lux", 1, 1, "amount",
                 "illuminance as the colour of a light_source that does not fade",
                 General(light_of_lux), "light_source { <-4, 6, -8>, rgb lux(500) }"},
    FunctionInfo{"max", 1, FunctionInfo::any, "a, ...", "the greatest", General(greatest),
                 "max(1, 5, 3) -> 5"},
    FunctionInfo{"min", 1, FunctionInfo::any, "a, ...", "the least", General(least),
                 "min(1, 5, 3) -> 1"},
    FunctionInfo{"mod", 2, 2, "a, b", "remainder of a / b, with the sign of a", General(remainder),
                 "mod(7, 3) -> 1"},
    FunctionInfo{"nit", 1, 1, "amount",
                 "luminance, in candela per square metre, as the radiance of an emission",
                 General(light_of_nits),
                 "sphere { y, 0.1 pigment { rgb 1 } finish { emission nit(2000) } }"},
    FunctionInfo{"pow", 2, 2, "base, exponent", "base to the power of the exponent", General(power),
                 "pow(2, 10) -> 1024"},
    FunctionInfo{"prod", 4, 4, "i, first, last, e", "product, in functions only", General(not_yet),
                 "#declare F = function { prod(i, 1, 3, x + i) };"},
    FunctionInfo{"radians", 1, 1, "x", "degrees to radians",
                 Unary([](double x) { return x * radians_per_degree; }),
                 "radians(180) -> 3.141593"},
    FunctionInfo{"rand", 1, 1, "stream", "the next random number of a stream, 0 to 1",
                 General(next_random), "#declare Stream = seed(7); #declare Share = rand(Stream);"},
    FunctionInfo{
        "read_csv", 1, 2, "name[, options]",
        "the rows of a table in a file: an array of rows by columns, of numbers and "
        "strings; A[row][\"name\"] finds a column by its header; options are words in a string: "
        "header, no_header, text, comma, semicolon, tab, bar, blank",
        General(csv_file),
        "#declare Lamps = read_csv(\"lamps.csv\"); #declare Height = Lamps[0][\"y\"];"},
    FunctionInfo{"read_json", 1, 2, "name[, path]",
                 "what is in a JSON file, or in one place of it: a number, a string, or an array, "
                 "whose members have names: A[\"lamps.0.radiance\"]",
                 General(json_file),
                 "#declare Brightness = read_json(\"lamps.json\", \"lamps.0.radiance\");"},
    FunctionInfo{"seed", 1, 1, "n", "a new random stream", General(new_random),
                 "#declare Stream = seed(7);"},
    FunctionInfo{"select", 3, 4, "v, a, b[, c]", "a if v < 0, else b; with c: b if v = 0, else c",
                 General(select), "select(-1, 10, 20) -> 10"},
    FunctionInfo{"sin", 1, 1, "x", "sine of radians", Unary([](double x) { return math::sin(x); }),
                 "sin(pi/2) -> 1"},
    FunctionInfo{"sinh", 1, 1, "x", "hyperbolic sine",
                 Unary([](double x) { return math::sinh(x); }), "sinh(0) -> 0"},
    FunctionInfo{"sqrt", 1, 1, "x", "square root", General(square_root), "sqrt(16) -> 4"},
    FunctionInfo{"str", 3, 3, "x, width, digits", "a number as text", General(number_text),
                 "str(pi, 0, 3) -> \"3.142\""},
    FunctionInfo{"strcmp", 2, 2, "a, b",
                 "below, equal to, above 0: a comes before, is, comes after b", General(compare),
                 "strcmp(\"lamp\", \"lamp\") -> 0"},
    FunctionInfo{"strlen", 1, 1, "text", "number of characters", General(character_number),
                 "strlen(\"lamp\") -> 4"},
    FunctionInfo{"strlwr", 1, 1, "text", "in small letters (ASCII)", General(lower_case),
                 "strlwr(\"Lamp\") -> \"lamp\""},
    FunctionInfo{"strupr", 1, 1, "text", "in capitals (ASCII)", General(upper_case),
                 "strupr(\"Lamp\") -> \"LAMP\""},
    FunctionInfo{"substr", 3, 3, "text, start, length", "part of a string; start counts from 1",
                 General(substring), "substr(\"lantern\", 1, 3) -> \"lan\""},
    FunctionInfo{"sum", 4, 4, "i, first, last, e", "sum, in functions only", General(not_yet),
                 "#declare F = function { sum(i, 1, 3, i*x) };"},
    FunctionInfo{"tan", 1, 1, "x", "tangent of radians",
                 Unary([](double x) { return math::tan(x); }), "tan(pi/4) -> 1"},
    FunctionInfo{"tanh", 1, 1, "x", "hyperbolic tangent",
                 Unary([](double x) { return math::tanh(x); }), "tanh(0) -> 0"},
    FunctionInfo{"val", 1, 1, "text", "the number that the text begins with", General(number_in),
                 "val(\"2.5\") -> 2.5"},
    FunctionInfo{"vaxis_rotate", 3, 3, "v, axis, degrees", "v turned about an axis",
                 General(rotated_about), "vaxis_rotate(x, z, 90) -> <0, 1, 0>"},
    FunctionInfo{"vcross", 2, 2, "a, b", "cross product", General(cross_product),
                 "vcross(x, y) -> <0, 0, 1>"},
    FunctionInfo{"vdot", 2, 2, "a, b", "dot product", General(dot_product),
                 "vdot(<1, 2, 3>, y) -> 2"},
    FunctionInfo{"vlength", 1, 1, "v", "length", General(vector_length), "vlength(<3, 4, 0>) -> 5"},
    FunctionInfo{"vnormalize", 1, 1, "v", "v with length 1", General(normalised),
                 "vnormalize(<0, 0, 2>) -> <0, 0, 1>"},
    FunctionInfo{"vrotate", 2, 2, "v, degrees", "v turned about x, then y, then z",
                 General(rotated), "vrotate(x, 90*z) -> <0, 1, 0>"},
    FunctionInfo{"vstr", 5, 5, "n, v, separator, width, digits", "n numbers of a vector as text",
                 General(vector_text), "vstr(3, <1, 2, 3>, \" \", 0, 1) -> \"1.0 2.0 3.0\""},
    FunctionInfo{"vturbulence", 4, 4, "lambda, omega, octaves, point", "sum of noises as a vector",
                 General(vector_turbulence), "#declare Shift = vturbulence(2, 0.5, 6, <1, 2, 3>);"},
    FunctionInfo{
        "watt", 2, 2, "power, efficacy",
        "luminous flux of an electric power, by its lumens per watt: about 12 for filament "
        "lamps, 100 for LED lamps",
        General(light_of_watts),
        "sphere { y, 0.1 pigment { rgb 1 } luminaire { flux watt(8, 100) } }"},
    FunctionInfo{"wavelength", 1, 1, "nanometres",
                 "colour of light of one wavelength, 380 to 780, with luminance 1",
                 General(colour_of_wavelength), "light_source { 5*y, wavelength(589) }"},
};

}  // namespace

std::span<const FunctionInfo> functions() { return table; }

}  // namespace candelabra
