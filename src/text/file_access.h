// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Rules on the files that a scene may access. The run names folders; a scene reads and writes below
// them and nowhere else. Links are resolved before a path is judged, so none leads outside. The
// loader asks about reading, the evaluator about writing. The run's own pictures are exempt.

#include "text/made_files.h"
#include "text/scene_folders.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace candelabra {

class FileAccess {
public:
    /// Permits all reading and no writing; for readers that do not access the disk.
    FileAccess() = default;

    /// Permits reading below all of these folders and writing below the writable ones. The first
    /// writable folder is the scene's own: it is made when it is needed, relative names are written
    /// below it, and its files have names of data (text/written_name.h). In the other folders,
    /// which the user has named, names are freer, files made by others are overwritten, too, and
    /// relative names are written that lead there from the current directory. "" or "." is the
    /// current directory.
    FileAccess(const std::vector<std::string>& readable, std::vector<std::string> writable);

    /// Also permits reading from the folders of a run.
    void reads(const SceneFolders&);

    /// Sets the record of files that the scene has made in this run and before. Without it, only
    /// new files are written.
    void remembers(std::shared_ptr<MadeFiles> made) { made_ = std::move(made); }

    bool may_read(const std::string& path) const { return admitted(path).has_value(); }
    /// Resolves the links in a path that may be read; returns nothing if it may not. Hidden files
    /// and names with control characters are not read. Accesses nothing but links.
    std::optional<std::string> admitted(const std::string& path) const;
    /// Like admitted(), but resolves links even if no folders are named.
    std::optional<std::string> place(const std::string& path) const;
    /// Whether a path that may be read leads to a special file, neither a regular file nor a
    /// folder: a pipe or a device.
    bool is_special(const std::string& path) const;

    /// Resolves the links in a name that a scene writes to; returns nothing if it must not be
    /// written, whether or not the file exists. Names that begin with a point are never written,
    /// because they belong to other programs; neither are settings and states, which other runs
    /// trust.
    std::optional<std::string> destination(const std::string& name) const;
    /// Returns the rule that forbids writing to an existing file at the destination; empty if none
    /// does.
    std::string rule_of_file(const std::string& destination) const;
    /// Opens a destination.
    OpenedFile open(const std::string& destination, bool append) const;
    /// Returns the scene's own folder, as the constructor was given it, if it exists; else "".
    std::string own_folder() const;
    /// Whether the file bears the mark of another scene.
    bool is_of_another(const std::string& path) const;

    /// These return the rule in one line, and the way to allow more, for messages about this path.
    static std::string reading_rule();
    /// Names the folder that is not read because it is too wide; empty if there is none.
    std::string left_out_note() const;
    std::string writing_rule(const std::string& name) const;
    static std::string reading_help(const std::string& path);
    /// Empty if nothing would allow it.
    std::string writing_help(const std::string& name) const;

private:
    /// A path without links below a writable folder, and the rule that forbids it; empty: none.
    struct WritablePlace {
        std::string path, rule;
    };
    std::optional<WritablePlace> writable_place(const std::string& name) const;
    /// Returns the part of a path below a folder that the user permits, or nothing.
    std::optional<std::filesystem::path> below_permitted(const std::filesystem::path& real) const;
    bool admits(const std::filesystem::path& real) const;
    /// Whether files made by others may be overwritten there, too.
    bool overwrites(const std::string& destination) const;

    std::vector<std::string> readable_;  ///< absolute, without links
    std::vector<std::string> writable_;
    std::vector<FolderFiles> files_;
    std::string left_out_;
    std::string write_folder_;  ///< as the constructor was given it
    std::shared_ptr<MadeFiles> made_ = std::make_shared<MadeFiles>(std::string());
    bool locked_ = false;
};

}  // namespace candelabra
