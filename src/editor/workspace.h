// SPDX-License-Identifier: GPL-3.0-or-later
// The files in an editor, with its current texts, and the files that they include, as on the disk.
// Answers are derived from tokens, so that they are available while a file is full of errors.
#pragma once

#include "editor/edited_file.h"
#include "text/loader.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace candelabra {

/// A snapshot of a file at the time of the call.
using FileHandle = std::shared_ptr<const EditedFile>;

class Workspace {
public:
    /// `library`: folder of the standard library, or "".
    explicit Workspace(std::string library) : library_(std::move(library)) {}

    void open(const std::string& path, std::string text);
    void close(const std::string& path);
    bool is_open(const std::string& path) const { return documents_.contains(path); }
    std::vector<std::string> open_files() const;

    /// Returns the file as the editor has it, or else as it is on the disk; null if there is none.
    FileHandle file(const std::string& path);
    /// Returns the file, its includes, and the other open files and their includes, without
    /// duplicates; 1000 at most.
    std::vector<FileHandle> around(const std::string& path);
    /// A declaration of a name, as seen from a place. Those in the same file come first: the ones
    /// above the place, nearest first, before the others.
    struct Found {
        FileHandle file;
        const DeclaredName* declaration;
    };
    std::vector<Found> declarations(NameId, const std::string& path, std::uint32_t offset);

    /// Returns a loader for a scene in this folder; open documents take precedence over the disk.
    /// It reads the files that the FileAccess permits, by default those that belong to open scenes.
    Loader loader(const std::string& folder) const;
    Loader loader(const std::string& folder, const FileAccess& access) const;
    bool in_library(const std::string& path) const;
    const std::string& library() const { return library_; }
    Names& names() { return names_; }

private:
    static constexpr std::size_t max_files = 1000;

    Reader reader(const FileAccess&) const;
    void add_with_includes(const std::string& path, const std::string& folder,
                           std::vector<FileHandle>& files);

    std::string library_;
    Names names_;
    std::map<std::string, std::string> documents_;
    std::map<std::string, FileHandle> read_;  ///< tokenised files
};

}  // namespace candelabra
