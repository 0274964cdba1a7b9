// SPDX-License-Identifier: GPL-3.0-or-later
// Restrictions on INI files that are not the user's own settings, since they may have come with a
// scene. Paths must lie below the folder of the file or in permitted folders. Such a file may not
// raise limits, give permissions or open the preview. Used by the reader of options.
#pragma once

#include "options/option_table.h"
#include "text/loader.h"

#include <optional>
#include <string>
#include <vector>

namespace candelabra {

/// The rule that an option breaks, and how to satisfy it. The rule is empty if none is broken.
struct BrokenRule {
    std::string rule, help;
};

class Confinement {
public:
    /// `outside`: the options in effect outside of the file, with the permitted folders.
    Confinement(const std::string& ini_file, const Options& outside);

    BrokenRule of_option(const OptionRow&, const Given&) const;
    /// Checks a scene, whose extension may be missing, or another INI file that is given as an
    /// argument.
    BrokenRule of_read(const std::string& path) const;
    /// Returns a reader confined to the permitted folders. The file that is checked is the file
    /// that is read.
    Reader reader(const Reader& of_all) const { return of_all.within(FileAccess(readable_, {})); }
    /// Whether a limit is higher than outside of the file. limit_rule() is the message for this.
    bool exceeded(const Options&) const;
    static std::string limit_rule();

private:
    BrokenRule of_file(const std::string& path) const;
    BrokenRule of_written(const std::string& path, bool ini) const;
    std::string folder_rule() const;

    std::string folder_;                            ///< as given in the name of the file
    std::vector<std::string> readable_, writable_;  ///< without symbolic links
    Limits limits_;
    std::uint64_t memory_bytes_;
};

}  // namespace candelabra
