// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/suggestions.h"

#include "bind/object_functions.h"
#include "editor/hover.h"
#include "scene/catalogue.h"
#include "vocabulary/manual.h"

#include <algorithm>
#include <unordered_set>

namespace candelabra {

namespace {

class Suggestions {
public:
    void add(Suggestion suggestion) {
        if (known_.insert(suggestion.text).second) all_.push_back(std::move(suggestion));
    }

    void add_directives() {
        for (const Word& word : reserved_words())
            if (word.word_class == WordClass::directive)
                add({std::string(word.spelling), Suggestion::directive, "directive", ""});
    }

    /// The fields of the block's item, and its kinds.
    void add_block(std::string_view block) {
        for (const ItemGroup& group : catalogue())
            for (const ItemInfo* item : group.items) {
                if (group.block == block) add_item(*item, group.block);
                if (item->name != block) continue;
                for (std::size_t i = 0; i < item->fields.size(); ++i)
                    if (item->fields[i].is_word())
                        add({std::string(item->fields[i].name), Suggestion::field, values(*item, i),
                             std::string(item->fields[i].help)});
            }
    }

    void add_names(Workspace& workspace, const std::string& path) {
        for (const FileHandle& file : workspace.around(path))
            for (const DeclaredName& each : file->declarations) {
                if (each.local && file->path != path) continue;
                const bool macro = each.kind == DeclaredName::macro;
                add({std::string(workspace.names().spelling(each.name)),
                     macro ? Suggestion::macro : Suggestion::name,
                     file->path.substr(file->path.rfind('/') + 1), ""});
            }
    }

    void add_words() {
        for (const FunctionInfo& each : all_functions())
            add({std::string(each.name), Suggestion::function,
                 std::string(each.name) + "(" + std::string(each.arguments) + ")",
                 std::string(each.help)});
        for (const ItemGroup& group : catalogue())
            for (const ItemInfo* item : group.items) add_item(*item, group.block);
        for (const Word& word : reserved_words())
            if (word.word_class != WordClass::directive)
                add({std::string(word.spelling), Suggestion::word, "", ""});
    }

    void add_files(const Workspace& workspace, const std::string& folder) {
        for (const std::string& place : {folder, workspace.library()}) {
            if (place.empty()) continue;
            std::vector<std::string> names = disk_lister()(place);
            std::ranges::sort(names);
            for (const std::string& name : names)
                if (name.ends_with(".inc"))
                    add({name, Suggestion::file, place == folder ? "" : "standard library", ""});
        }
    }

    std::vector<Suggestion> take() { return std::move(all_); }

private:
    void add_item(const ItemInfo& item, std::string_view block) {
        add({std::string(item.name), Suggestion::item, usage(item, block), std::string(item.help)});
    }

    std::vector<Suggestion> all_;
    std::unordered_set<std::string> known_;
};

}  // namespace

std::vector<Suggestion> suggestions(Workspace& workspace, const std::string& path,
                                    std::uint32_t offset) {
    const FileHandle file = workspace.file(path);
    if (!file) return {};
    Suggestions result;
    const std::string_view before = std::string_view(file->text).substr(0, offset);
    const std::string_view line = before.substr(before.rfind('\n') + 1);
    const std::size_t hash = line.rfind('#');
    const std::string_view directive = hash == line.npos ? "" : line.substr(hash);
    if (directive.starts_with("#include") && std::ranges::count(directive, '"') == 1) {
        result.add_files(workspace, directory_of(path));
    } else if (!directive.empty() &&
               directive.find_first_not_of("abcdefghijklmnopqrstuvwxyz", 1) == directive.npos) {
        result.add_directives();
    } else {
        for (const NameId block : blocks_around(*file, offset))
            result.add_block(workspace.names().spelling(block));
        result.add_names(workspace, path);
        result.add_words();
    }
    return result.take();
}

}  // namespace candelabra
