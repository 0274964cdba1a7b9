// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/string_functions.h"

#include "text/ascii.h"
#include "text/message.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace candelabra {

namespace {

using Call = FunctionCall&;

/// Doubles hold all whole numbers up to this one exactly.
constexpr double max_whole = 9007199254740992.0;

/// Writes the digits of a finite number, rounded to even as C's %f does. Returns their end.
char* write_digits(char* first, char* last, double value, int precision) {
    if (precision > 0 || std::abs(value) >= max_whole)
        return std::to_chars(first, last, value, std::chars_format::fixed, precision).ptr;
    const double whole = std::nearbyint(value);
    if (whole == 0 && std::signbit(value)) *first++ = '-';
    return std::to_chars(first, last, static_cast<std::int64_t>(whole)).ptr;
}

/// The size in bytes of the UTF-8 character that begins at `at`. A stray byte counts as a
/// character.
std::size_t character_size(std::string_view text, std::size_t at) {
    const auto lead = static_cast<unsigned char>(text[at]);
    std::size_t size = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC0 ? 2 : 1;
    for (std::size_t i = 1; i < size; ++i)
        if (at + i >= text.size() || (static_cast<unsigned char>(text[at + i]) & 0xC0) != 0x80)
            return 1;
    return size;
}

std::size_t length_in_characters(std::string_view text) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < text.size(); i += character_size(text, i)) ++count;
    return count;
}

double character_code(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) {
        return static_cast<unsigned>(static_cast<unsigned char>(text[at + i]));
    };
    switch (character_size(text, at)) {
        case 2:
            return (byte(0) & 0x1F) << 6 | (byte(1) & 0x3F);
        case 3:
            return (byte(0) & 0x0F) << 12 | (byte(1) & 0x3F) << 6 | (byte(2) & 0x3F);
        case 4:
            return (byte(0) & 0x07) << 18 | (byte(1) & 0x3F) << 12 | (byte(2) & 0x3F) << 6 |
                   (byte(3) & 0x3F);
        default:
            return byte(0);
    }
}

}  // namespace

void append_formatted(std::string& text, double value, double length, double digits) {
    constexpr int most = 1000;
    const auto limited = [](double x) {
        return static_cast<int>(std::fmax(-most, std::fmin(most, std::isnan(x) ? 0 : x)));
    };
    const int width = limited(length);
    const int precision = digits < 0 ? 6 : limited(digits);
    std::array<char, most + 400> buffer;  // the greatest number has 309 digits before the point
    char* const first = buffer.data();
    char* const last = first + buffer.size();
    const bool finite = std::isfinite(value);
    const char* const end = finite ? write_digits(first, last, value, precision)
                                   : first + std::snprintf(first, buffer.size(), "%f", value);
    const auto size = static_cast<std::size_t>(end - first);
    const auto wanted = static_cast<std::size_t>(std::abs(width));
    const std::size_t missing = wanted > size ? wanted - size : 0;
    if (width < 0 && finite) {
        // Zeros go between the sign and the digits.
        const std::size_t sign = *first == '-' ? 1 : 0;
        text.append(first, sign).append(missing, '0').append(first + sign, size - sign);
    } else {
        text.append(missing, ' ').append(first, size);
    }
}

Value number_text(Call call) {
    std::string text;
    append_formatted(text, call.number(0), call.number(1), call.number(2));
    return text;
}

Value vector_text(Call call) {
    const int n = static_cast<int>(std::fmax(2, std::fmin(5, call.number(0))));
    const Numbers& v = call.numbers(1);
    const std::string_view separator = call.text(2);
    const double length = call.number(3), digits = call.number(4);
    std::string text;
    for (int i = 0; i < n; ++i) {
        if (i > 0) text += separator;
        append_formatted(text, i < v.count ? v.at[static_cast<std::size_t>(i)] : 0, length, digits);
    }
    return text;
}

Value character(Call call) {
    const double value = call.number(0);
    if (!(value >= 0 && value < 65536))
        return call.fail(Fault::out_of_range, 0,
                         message("a character's code is from 0 to 65535, but this is ", value));
    const auto code = static_cast<unsigned>(value);
    std::string text;
    if (code == 0) return text;  // It ends a string.
    if (code < 0x80)
        text = {static_cast<char>(code)};
    else if (code < 0x800)
        text = {static_cast<char>(0xC0 | code >> 6), static_cast<char>(0x80 | (code & 0x3F))};
    else
        text = {static_cast<char>(0xE0 | code >> 12), static_cast<char>(0x80 | (code >> 6 & 0x3F)),
                static_cast<char>(0x80 | (code & 0x3F))};
    return text;
}

Value substring(Call call) {
    const std::string_view text = call.text(0);
    const std::int64_t start = call.integer(1), length = call.integer(2);
    const auto size = static_cast<std::int64_t>(length_in_characters(text));
    if (call.failed()) return Absence::broken;
    // As in POV-Ray, the end of a string is also in front of the first character.
    if (start == 0 && length >= 0 && length <= size + 1) return std::string();
    if (start < 1 || start > size + 1)
        return call.fail(Fault::out_of_range, 1,
                         message("the string has characters 1 to ", size, ", and this is ", start));
    if (length < 0 || length > size - start + 1)
        return call.fail(Fault::out_of_range, 2,
                         message("from ", start, " on the string has ", size - start + 1,
                                 " characters, but the length is ", length));
    std::size_t first = 0;
    for (std::int64_t i = 1; i < start; ++i) first += character_size(text, first);
    std::size_t last = first;
    for (std::int64_t i = 0; i < length; ++i) last += character_size(text, last);
    return std::string(text.substr(first, last - first));
}

Value compare(Call call) {
    const std::string_view a = call.text(0), b = call.text(1);
    std::size_t i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
        const double difference = character_code(a, i) - character_code(b, j);
        if (difference != 0) return difference;
        i += character_size(a, i);
        j += character_size(b, j);
    }
    return (i < a.size() ? character_code(a, i) : 0) - (j < b.size() ? character_code(b, j) : 0);
}

Value concatenated(Call call) {
    std::string text(call.text(0));
    for (std::size_t i = 1; i < call.count(); ++i) text += call.text(i);
    return text;
}

Value number_in(Call call) { return std::strtod(std::string(call.text(0)).c_str(), nullptr); }

Value lower_case(Call call) { return candelabra::lower_case(call.text(0)); }

Value upper_case(Call call) {
    std::string text(call.text(0));
    for (char& c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
    return text;
}

Value first_code(Call call) {
    const std::string_view text = call.text(0);
    return text.empty() ? 0.0 : character_code(text, 0);
}

Value character_number(Call call) {
    return static_cast<double>(length_in_characters(call.text(0)));
}

Value date_text(Call call) {
    // Days since the year 2000 began, in UTC.
    const double seconds = call.number(0) * 86400 + 946684800;
    const std::string format(call.count() > 1 ? call.text(1) : "%Y-%m-%d %H:%M:%SZ");
    if (call.failed()) return Absence::broken;
    if (!(std::abs(seconds) < 1e15)) return call.fail(Fault::domain, 0, "this is no date");
    const auto time = static_cast<std::time_t>(std::floor(seconds + 0.5));
    std::tm parts{};
    std::array<char, 1024> buffer;
    if (!gmtime_r(&time, &parts)) return call.fail(Fault::domain, 0, "this is no date");
    return std::string(buffer.data(),
                       std::strftime(buffer.data(), buffer.size(), format.c_str(), &parts));
}

}  // namespace candelabra
