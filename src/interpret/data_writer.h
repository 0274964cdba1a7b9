// SPDX-License-Identifier: GPL-3.0-or-later
// Writes values into a file for #write, as text or as binary numbers. Disk errors are kept until
// good() or close() is called.
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

/// The binary format of a number: `uint16le` is {2, false, false}.
struct BinaryForm {
    int bytes = 1;
    bool is_signed = false;
    bool big_end_first = false;
};

/// The form of this name, or nothing.
std::optional<BinaryForm> binary_form(std::string_view name);

class DataWriter {
public:
    /// Writes to a file that FileAccess has opened. A closed file counts as failed.
    explicit DataWriter(OpenedFile);
    /// Appends to this text and writes to no disk.
    explicit DataWriter(std::shared_ptr<std::string> text) : text_(std::move(text)) {}

    /// Whether the file is open and all writes so far have succeeded.
    bool good() const { return !failed_; }

    /// Writes text: strings unchanged, numbers with six digits, vectors as `<x,y,z> ` with a blank.
    void write(const Value&);
    /// Writes each number rounded, and clamped to the range of the form.
    void write(const Numbers&, BinaryForm);

    /// Number of bytes written so far.
    std::uint64_t bytes() const { return bytes_; }
    /// Closes the file. False if that, or any write, has failed.
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
