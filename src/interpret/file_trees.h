// SPDX-License-Identifier: GPL-3.0-or-later
// The trees of a scene's files. An include file is parsed when the walk reaches its #include, or
// earlier, when a file that names it is parsed: it may define open macros, which the parser has to
// know. Its errors are reported when the walk reaches it.
#pragma once

#include "syntax/parser.h"
#include "text/loader.h"

#include <deque>
#include <map>
#include <string>
#include <utility>

namespace candelabra {

class FileTrees {
public:
    FileTrees(SourceStore& sources, const Loader& loader, Names& names, Diagnostics& diagnostics)
        : sources_(sources), loader_(loader), names_(names), diagnostics_(diagnostics) {}

    /// Parses the scene itself.
    const Tree& main(SourceId, double version);
    /// The file of an #include.
    struct Included {
        const Tree* tree;
        bool first;         ///< whether this is its first #include
        Diagnostics found;  ///< at the first #include: its diagnostics
    };
    Included included(const Found&, Span, double version);
    /// Forgets the file at this path, whose content has changed.
    void forget(const std::string& path) { files_.erase(path); }

    /// The path of a file that defines an open macro of this name, or null.
    const std::string* opening(NameId macro) const;

    const std::deque<Tree>& all() const { return trees_; }
    /// Maximum depth of nested includes.
    std::size_t deepest = 100;

private:
    struct File {
        const Tree* tree = nullptr;  ///< null while it is being parsed
        double version = 0;          ///< of the language, when it was parsed
        Diagnostics found = {};
        OpenMacroList macros = {};  ///< known at its end
        bool met = false;           ///< the walk has reached it
    };

    ParseOptions options(double version, bool included, OpenMacroList&);
    File& parse_file(const Found&, Span, double version, OpenMacroList known);
    /// Parses the file of an #include that the parser has met.
    void read_ahead(const std::string& name, Span, double version, OpenMacroList& known);

    SourceStore& sources_;
    const Loader& loader_;
    Names& names_;
    Diagnostics& diagnostics_;
    std::deque<Tree> trees_;
    std::map<std::string, File> files_;                                 ///< by path
    std::map<std::pair<std::string, std::string>, std::string> paths_;  ///< by folder and name
    OpenMacroList of_main_;  ///< known at the end of the scene
    std::size_t depth_ = 0;
};

}  // namespace candelabra
