// SPDX-License-Identifier: GPL-3.0-or-later
// The files that an editor works on, as it has them, and those that they include, as the disk has
// them. Answers come from tokens, so that they are there while a file is full of errors.
#pragma once

#include "editor/edited_file.h"
#include "text/loader.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace candelabra {

/// As it was when it was asked for.
using FileHandle = std::shared_ptr<const EditedFile>;

class Workspace {
public:
    /// `library`: folder of the standard library, or "".
    explicit Workspace(std::string library) : library_(std::move(library)) {}

    void open(const std::string& path, std::string text);
    void close(const std::string& path);
    bool is_open(const std::string& path) const { return documents_.contains(path); }
    std::vector<std::string> open_files() const;

    /// The file as the editor has it, or else as it is on the disk; null when there is none.
    FileHandle file(const std::string& path);
    /// The file, what it includes, the other open files and what they include; each once, and no
    /// more than 1000.
    std::vector<FileHandle> around(const std::string& path);
    /// Where the name gets its meanings, seen from a place: first those in the same file, the
    /// nearest above the place before others.
    struct Found {
        FileHandle file;
        const DeclaredName* declaration;
    };
    std::vector<Found> declarations(NameId, const std::string& path, std::uint32_t offset);

    /// Finds files for a scene in this folder; open documents come before the disk. It reads what
    /// the FileAccess permits, by default what belongs to open scenes.
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
    std::map<std::string, FileHandle> read_;  ///< files with their tokens
};

}  // namespace candelabra
