// SPDX-License-Identifier: GPL-3.0-or-later
// What an INI file may say that is not one of the user's own settings, since it may have come with
// a scene: paths lie below its folder, or where the user has permitted something; limits are not
// raised, nothing is permitted, no page is opened. The reader of options asks.
#pragma once

#include "app/option_table.h"
#include "text/loader.h"

#include <optional>
#include <string>
#include <vector>

namespace candelabra {

/// The rule that an option breaks, and the way out. No rule: it breaks none.
struct BrokenRule {
    std::string rule, help;
};

class Confinement {
public:
    /// The options as they are outside of the file, with the folders that are permitted.
    Confinement(const std::string& ini_file, const Options& outside);

    BrokenRule of_option(const OptionRow&, const Given&) const;
    /// For a scene, whose ending may be left out, or another INI file that stands alone.
    BrokenRule of_read(const std::string& path) const;
    /// For these files: the one that is judged is the one that is read.
    Reader reader(const Reader& of_all) const { return of_all.within(FileAccess(readable_, {})); }
    /// Whether a limit is higher than outside of the file, and what is said then.
    bool exceeded(const Options&) const;
    static std::string limit_rule();

private:
    BrokenRule of_file(const std::string& path) const;
    BrokenRule of_written(const std::string& path, bool ini) const;
    std::string folder_rule() const;

    std::string folder_;                            ///< as the file's name has it
    std::vector<std::string> readable_, writable_;  ///< without links
    Limits limits_;
    std::uint64_t memory_bytes_;
};

}  // namespace candelabra
