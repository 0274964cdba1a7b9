// SPDX-License-Identifier: GPL-3.0-or-later
// The value that `#fopen` declares: a file that is open for reading or for writing. It is closed by
// #fclose, by #read at its end, and with the last value that refers to it. The directives are in
// files.cpp, as members of the evaluator's state.
#pragma once

#include "interpret/data_reader.h"
#include "interpret/data_writer.h"

#include <memory>
#include <string>

namespace candelabra {

struct DataFile {
    DataFile(std::string name_, Span opened_) : name(std::move(name_)), opened(opened_) {}
    DataFile(DataFile&&) = default;
    ~DataFile() {
        if (writer) writer->close();
    }

    std::string name;  ///< as the scene writes it
    Span opened;
    std::unique_ptr<DataReader> reader;  ///< one of these two
    std::shared_ptr<DataWriter> writer;
};

/// A file opened for writing, kept to check in the end whether all of it was written.
struct WrittenFile {
    std::string name;
    Span opened;
    std::shared_ptr<DataWriter> writer;
};

}  // namespace candelabra
