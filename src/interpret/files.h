// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the evaluator that reads and writes files: #fopen, #fclose, #read and #write. The
// value that `#fopen` declares is an open file. It is closed by #fclose, by #read at its end, and
// with the last value that refers to it. Internal to the evaluator.
#pragma once

#include "interpret/context.h"
#include "interpret/data_reader.h"
#include "interpret/data_writer.h"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

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

class DataFiles {
public:
    explicit DataFiles(Context& context) : context_(context) {}

    void open_file(const Tree&, const node::Open&, NodeId);
    void close_file(const Tree&, const node::Close&, NodeId);
    void read_values(const Tree&, const node::Read&, NodeId);
    void write_values(const Tree&, const node::Write&, NodeId);
    /// Checks, at the end, the files that the scene did not close.
    void check_written_files();

private:
    void open_for_reading(DataFile&, Span);
    SourceId data_source(Found, Span);
    void open_for_writing(DataFile&, bool append, Span);
    std::unique_ptr<DataWriter> writer_for(const std::string& path, bool append);
    /// The open file of a name; null after a report.
    Handle<DataFile> open_file_named(const Tree&, NodeId);
    Handle<DataFile> open_file_named(NameId, Span);
    void check_written(const std::shared_ptr<DataWriter>&, Span);
    bool read_into(const Tree&, NodeId target, DataReader&);
    void warn_of_line_end(const DataFile&, Span target, Span before);
    void write_value(DataWriter&, const Value&, const std::optional<BinaryForm>&, Span);

    Context& context_;
    std::vector<WrittenFile> written_files_;        ///< that are still to be checked
    std::map<std::string, SourceId> data_sources_;  ///< of #fopen, by path
    std::set<std::string> crossed_lines_;  ///< files in which a #read continued in the next line
};

}  // namespace candelabra
