// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/file_trees.h"

#include <algorithm>

namespace candelabra {

ParseOptions FileTrees::options(double version, bool included, OpenMacroList& known) {
    const auto reader = [this](const std::string& name, Span at, double version,
                               OpenMacroList& known) { read_ahead(name, at, version, known); };
    return {version, true, included, &known, reader};
}

const Tree& FileTrees::main(SourceId source, double version) {
    return trees_.emplace_back(
        parse(source, sources_, names_, diagnostics_, options(version, false, of_main_)));
}

FileTrees::File& FileTrees::parse_file(const Found& found, Span at, double version,
                                       OpenMacroList known) {
    File& file = files_[found.path];
    file = {nullptr, version, diagnostics_.fresh()};
    ++depth_;
    const SourceId source = sources_.add(found.path, found.text, at);
    file.tree = &trees_.emplace_back(
        parse(source, sources_, names_, file.found, options(version, true, known)));
    --depth_;
    file.macros = std::move(known);
    return file;
}

void FileTrees::read_ahead(const std::string& name, Span at, double version, OpenMacroList& known) {
    const std::string folder = directory_of(sources_.name(at.source));
    const auto [path, is_new] = paths_.try_emplace({folder, name});
    auto file = files_.find(path->second);
    if (is_new || file == files_.end()) {
        const std::optional<Found> found =
            depth_ < deepest ? loader_.load(name, folder) : std::nullopt;
        path->second = found ? found->path : "";
        if (!found) return;
        file = files_.find(found->path);
        if (file == files_.end()) {
            known = parse_file(*found, at, version, known).macros;
            return;
        }
    }
    for (const auto& each : file->second.macros)
        if (std::ranges::find(known, each) == known.end()) known.push_back(each);
}

FileTrees::Included FileTrees::included(const Found& found, Span at, double version) {
    const auto known = files_.find(found.path);
    const auto fits = [&](const File& file) {
        return file.met ||
               (file.version == version && sources_.text(file.tree->source) == found.text);
    };
    File& file = known != files_.end() && fits(known->second)
                     ? known->second
                     : parse_file(found, at, version, of_main_);
    const bool first = !std::exchange(file.met, true);
    return {file.tree, first, first ? std::move(file.found) : diagnostics_.fresh()};
}

const std::string* FileTrees::opening(NameId macro) const {
    for (const auto& [path, file] : files_)
        for (const auto& each : file.macros)
            if (each->name == macro) return &path;
    return nullptr;
}

}  // namespace candelabra
