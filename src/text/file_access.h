// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which files a scene may touch. The run names folders; a scene reads and writes below them and
// nowhere else. Links are followed before a path is judged, so that none leads outside. The loader
// asks for reading, the evaluator for writing; pictures of the run itself do not come through here.

#include "text/made_files.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace candelabra {

class FileAccess {
public:
    /// Everything may be read and nothing written: for readers that know no disk.
    FileAccess() = default;

    /// Reading below all of these folders, writing below the writable ones; relative names are
    /// written below the first of them, where files of others stay as they are. "" or "." is the
    /// current directory.
    FileAccess(const std::vector<std::string>& readable, std::vector<std::string> writable);

    /// The files that the scene has made in this run and before; without it only files that are
    /// not there are written.
    void remembers(std::shared_ptr<MadeFiles> made) { made_ = std::move(made); }

    bool may_read(const std::string& path) const { return admitted(path).has_value(); }
    /// Where a path that may be read leads, with all links followed; nothing if it may not. Looks
    /// at nothing but links.
    std::optional<std::string> admitted(const std::string& path) const;
    /// The same, also where no folders are named.
    std::optional<std::string> place(const std::string& path) const;
    /// Whether a path that may be read leads to a special file, neither a regular file nor a
    /// folder: a pipe, a device.
    bool is_special(const std::string& path) const;

    /// Where a name that a scene writes to leads, with all links followed; nothing if it may not be
    /// written, whatever is there. Names that begin with a point are never written: they belong to
    /// other programs; neither are settings and states, which other runs believe.
    std::optional<std::string> destination(const std::string& name) const;
    /// The rule, or none, that keeps what is at a destination from being written to.
    std::string rule_of_file(const std::string& destination) const;
    /// Opens a destination.
    OpenedFile open(const std::string& destination, bool append) const;

    /// The rule in one line, and how to allow more, for messages about this path.
    std::string reading_rule() const;
    std::string writing_rule(const std::string& name) const;
    static std::string reading_help(const std::string& path);
    /// Empty: nothing would allow it.
    std::string writing_help(const std::string& name) const;

private:
    /// The writable folder that a path lies below.
    std::optional<std::size_t> writable_folder(const std::string& real) const;
    /// Whether files of others may be overwritten there, too.
    bool overwrites(const std::string& destination) const;

    std::vector<std::string> readable_;  ///< absolute, without links
    std::vector<std::string> writable_;
    std::string write_folder_;  ///< as it was given
    std::shared_ptr<MadeFiles> made_ = std::make_shared<MadeFiles>(std::string());
    bool locked_ = false;
};

}  // namespace candelabra
