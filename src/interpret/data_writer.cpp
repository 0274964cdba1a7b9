// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/data_writer.h"

#include "base/elementary.h"

#include <array>
#include <cmath>

namespace candelabra {

namespace {

struct NamedForm {
    std::string_view name;
    BinaryForm form;
};

constexpr auto forms = std::array{
    NamedForm{"uint8", {1, false, false}},    NamedForm{"sint8", {1, true, false}},
    NamedForm{"uint16le", {2, false, false}}, NamedForm{"uint16be", {2, false, true}},
    NamedForm{"sint16le", {2, true, false}},  NamedForm{"sint16be", {2, true, true}},
    NamedForm{"sint32le", {4, true, false}},  NamedForm{"sint32be", {4, true, true}},
};

std::FILE* as_stream(OpenedFile file) {
    std::FILE* const stream = file ? fdopen(file.descriptor(), "wb") : nullptr;
    if (stream) file.release();
    return stream;
}

}  // namespace

std::optional<BinaryForm> binary_form(std::string_view name) {
    for (const NamedForm& each : forms)
        if (each.name == name) return each.form;
    return std::nullopt;
}

DataWriter::DataWriter(OpenedFile file) : file_(as_stream(std::move(file))), failed_(!file_) {}

void DataWriter::put(std::string_view text) {
    bytes_ += text.size();
    if (text_) text_->append(text);
    if (text_ || failed_ || text.empty()) return;
    failed_ = std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size();
}

void DataWriter::write(const Value& value) {
    if (const std::string* text = value.text()) return put(*text);
    const Numbers* numbers = value.numbers();
    if (!numbers) return;
    std::array<char, 32> digits;
    for (int i = 0; i < numbers->count; ++i) {
        if (!numbers->is_scalar()) put(i == 0 ? "<" : ",");
        const int size = std::snprintf(digits.data(), digits.size(), "%g",
                                       numbers->at[static_cast<std::size_t>(i)]);
        put({digits.data(), static_cast<std::size_t>(size)});
    }
    if (!numbers->is_scalar()) put("> ");
}

void DataWriter::write(const Numbers& numbers, BinaryForm form) {
    const double most = math::exp2(8 * form.bytes - (form.is_signed ? 1 : 0)) - 1;
    const double least = form.is_signed ? -most - 1 : 0;
    for (int i = 0; i < numbers.count; ++i) {
        const double value = std::floor(numbers.at[static_cast<std::size_t>(i)] + 0.5);
        // NaN becomes the least.
        const double limited = value >= most ? most : value >= least ? value : least;
        const auto bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(limited));
        std::array<char, 4> bytes;
        for (int b = 0; b < form.bytes; ++b) {
            const int at = form.big_end_first ? form.bytes - 1 - b : b;
            bytes[static_cast<std::size_t>(at)] = static_cast<char>(bits >> 8 * b & 0xFF);
        }
        put({bytes.data(), static_cast<std::size_t>(form.bytes)});
    }
}

bool DataWriter::close() {
    if (std::FILE* file = file_.release()) failed_ = std::fclose(file) != 0 || failed_;
    return !failed_;
}

}  // namespace candelabra
