// SPDX-License-Identifier: GPL-3.0-or-later
// The files of a scene as trees. An include file is parsed when the walk comes to its #include, or
// before that, when a file is parsed that names it: it may define macros that open braces, which
// the parser has to know. Its errors are reported when the walk comes to it.
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

    /// The scene itself.
    const Tree& main(SourceId, double version);
    /// What an #include at that place has found.
    struct Included {
        const Tree* tree;
        bool first;         ///< it is the first #include of it
        Diagnostics found;  ///< the first time: what is wrong in it
    };
    Included included(const Found&, Span, double version);
    /// The file at this path is another one from now on.
    void forget(const std::string& path) { files_.erase(path); }

    /// The path of a file that defines a macro of this name which leaves braces open; null: none
    /// does.
    const std::string* opening(NameId macro) const;

    const std::deque<Tree>& all() const { return trees_; }
    /// How far files may include each other.
    std::size_t deepest = 100;

private:
    struct File {
        const Tree* tree = nullptr;  ///< null: it is being parsed
        double version = 0;          ///< that it was parsed for
        Diagnostics found = {};
        OpenMacroList macros = {};  ///< that are known behind it
        bool met = false;           ///< the walk has come to it
    };

    ParseOptions options(double version, bool included, OpenMacroList&);
    File& parse_file(const Found&, Span, double version, OpenMacroList known);
    /// For an #include that the parser has met.
    void read_ahead(const std::string& name, Span, double version, OpenMacroList& known);

    SourceStore& sources_;
    const Loader& loader_;
    Names& names_;
    Diagnostics& diagnostics_;
    std::deque<Tree> trees_;
    std::map<std::string, File> files_;                                 ///< by path
    std::map<std::pair<std::string, std::string>, std::string> paths_;  ///< by folder and name
    OpenMacroList of_main_;  ///< that the scene knows at its end
    std::size_t depth_ = 0;
};

}  // namespace candelabra
