// SPDX-License-Identifier: GPL-3.0-or-later
// What `#fopen` declares: a file that is open for reading or for writing. It is closed by #fclose,
// by #read at its end, and with the last value that refers to it. The directives are in files.cpp,
// as members of the evaluator's state.
#pragma once

#include "evaluate/data_reader.h"
#include "evaluate/data_writer.h"

#include <memory>
#include <string>

struct DataFile {
    std::string name;  ///< as the scene writes it
    Span opened;
    std::unique_ptr<DataReader> reader;  ///< one of these two
    std::unique_ptr<DataWriter> writer;
};
