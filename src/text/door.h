// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which files a scene may touch. The run names folders; a scene reads and writes below them and
// nowhere else. Links are followed before a path is judged, so that none leads outside. The loader
// asks for reading, the evaluator for writing; pictures of the run itself do not come through here.

#include <optional>
#include <string>
#include <vector>

class Door {
public:
    /// Everything may be read and nothing written: for readers that know no disk.
    Door() = default;

    /// Reading below all of these folders, writing below the writable ones; relative names are
    /// written below the first of them. "" or "." is the current directory.
    Door(const std::vector<std::string>& readable, std::vector<std::string> writable);

    bool may_read(const std::string& path) const;

    /// Where a name that a scene writes to leads, with all links followed; nothing if it may not be
    /// written. Names that begin with a point are never written: they belong to other programs.
    std::optional<std::string> destination(const std::string& name) const;

    /// The rule in one line, and how to allow more, for messages about this path.
    std::string reading_rule() const;
    std::string writing_rule() const;
    static std::string reading_help(const std::string& path);
    static std::string writing_help(const std::string& path);

private:
    std::vector<std::string> readable_;  ///< absolute, without links
    std::vector<std::string> writable_;
    std::string write_folder_;  ///< as it was given
    bool locked_ = false;
};
