// SPDX-License-Identifier: GPL-3.0-or-later
// Writes values into a file for #write, as text or as binary numbers. Errors of the disk are kept
// until somebody asks.
#pragma once

#include "interpret/value.h"
#include "text/opened_file.h"

#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

/// How a number is written: `uint16le` is {2, false, false}.
struct BinaryForm {
    int bytes = 1;
    bool is_signed = false;
    bool big_end_first = false;
};

/// The form with that name.
std::optional<BinaryForm> binary_form(std::string_view name);

class DataWriter {
public:
    /// A file that FileAccess has opened; a closed one has failed.
    explicit DataWriter(OpenedFile);
    /// What is written goes to the end of this text, and to no disk.
    explicit DataWriter(std::shared_ptr<std::string> text) : text_(std::move(text)) {}

    /// Whether there is such a file and all that was written has gone well so far.
    bool good() const { return !failed_; }

    /// As text: strings as they are, numbers with six digits, `<x,y,z> ` with a blank behind.
    void write(const Value&);
    /// Every number rounded, and limited to what the form can hold.
    void write(const Numbers&, BinaryForm);

    /// How much was written.
    std::uint64_t bytes() const { return bytes_; }
    /// Puts everything on the disk; false if that, or anything before, has failed.
    bool close();

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    void put(std::string_view);

    std::unique_ptr<std::FILE, Close> file_;
    std::shared_ptr<std::string> text_;  ///< instead of the file
    std::uint64_t bytes_ = 0;
    bool failed_ = false;
};

}  // namespace candelabra
