// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/symbols.h"

#include "editor/library_guide.h"
#include "text/ascii.h"

#include <algorithm>
#include <iterator>

namespace candelabra {

namespace {

constexpr std::size_t max_symbols = 1000;

bool same_folded(char a, char b) { return lower_case(a) == lower_case(b); }

bool begins_with(std::string_view name, std::string_view query) {
    return name.size() >= query.size() &&
           std::ranges::equal(name.substr(0, query.size()), query, same_folded);
}

bool has_letters(std::string_view name, std::string_view query) {
    for (const char letter : name)
        if (!query.empty() && same_folded(letter, query.front())) query.remove_prefix(1);
    return query.empty();
}

class SymbolSearch {
public:
    SymbolSearch(const Names& names, std::string_view query) : names_(names), query_(query) {}

    void look_in(const EditedFile& file, bool library) {
        const LibraryFile guide =
            library ? library_file(file.path.substr(file.path.rfind('/') + 1), file.text)
                    : LibraryFile();
        for (const DeclaredName& each : file.declarations) {
            const std::string_view name = names_.spelling(each.name);
            const bool is_macro = each.kind == DeclaredName::macro;
            if (each.local || each.kind == DeclaredName::parameter) continue;
            if (!has_letters(name, query_)) continue;
            if (library && !is_for_scenes(guide, name, is_macro)) continue;
            auto& list = begins_with(name, query_) ? first_ : others_;
            if (list.size() < max_symbols)
                list.push_back({std::string(name), is_macro, file.path, each.place});
        }
    }

    std::vector<Symbol> take() {
        std::ranges::move(others_, std::back_inserter(first_));
        if (first_.size() > max_symbols) first_.resize(max_symbols);
        return std::move(first_);
    }

private:
    const Names& names_;
    std::string_view query_;
    std::vector<Symbol> first_, others_;
};

}  // namespace

std::vector<Symbol> symbols(Workspace& workspace, std::string_view query) {
    const std::vector<std::string> open = workspace.open_files();
    if (open.empty()) return {};
    SymbolSearch search(workspace.names(), query);
    const std::vector<FileHandle> files = workspace.around(open.front());
    for (const bool library : {false, true})
        for (const FileHandle& file : files)
            if (workspace.in_library(file->path) == library && !(library && query.empty()))
                search.look_in(*file, library);
    return search.take();
}

}  // namespace candelabra
