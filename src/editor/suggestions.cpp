// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/suggestions.h"

#include "bind/block_words.h"
#include "editor/hover.h"
#include "editor/library_guide.h"
#include "objects/object_functions.h"
#include "scene/catalogue.h"
#include "text/ascii.h"
#include "vocabulary/glossary.h"
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

    /// Adds the words that the block takes; an empty name stands for a scene.
    void add_block(std::string_view block) {
        for (const BlockWord& each : block_words(block)) {
            const std::string word(each.word);
            if (each.field)
                add({word, Suggestion::field, values(*each.item, *each.field),
                     std::string(each.item->fields[*each.field].help)});
            else if (each.item)
                add_item(*each.item, each.home);
            else
                add_word(each.word);
        }
    }

    /// Adds names of the file itself, then of other files, and finally of the library.
    void add_names(Workspace& workspace, const std::string& path) {
        const std::vector<FileHandle> files = workspace.around(path);
        for (const FileHandle& file : files)
            if (file->path == path) add_own_names(*file, workspace.names(), true);
        for (const FileHandle& file : files)
            if (file->path != path && !workspace.in_library(file->path))
                add_own_names(*file, workspace.names(), false);
        for (const FileHandle& file : files)
            if (file->path != path && workspace.in_library(file->path))
                add_library_names(*file, workspace.names());
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
    /// Adds a word of the glossary or of an item.
    void add_word(std::string_view word) {
        if (const GlossaryEntry* entry = glossary_entry(word)) {
            add({std::string(word), Suggestion::word, std::string(entry->form),
                 std::string(entry->help)});
            return;
        }
        for (const ItemGroup& group : catalogue())
            for (const ItemInfo* item : group.items)
                if (item->name == word && group.block.empty()) add_item(*item, group.block);
        add({std::string(word), Suggestion::word, "", ""});
    }

    void add_own_names(const EditedFile& file, const Names& names, bool locals) {
        const LibraryFile guide = library_file({}, file.text);
        for (const DeclaredName& each : file.declarations)
            if (locals || !each.local) add_name(file, each, names, guide);
    }

    /// Skips aids of the library, which are names that end in `_` and macros that are not for
    /// scenes.
    void add_library_names(const EditedFile& file, const Names& names) {
        const LibraryFile guide = library_file(file_name(file), file.text);
        for (const DeclaredName& each : file.declarations) {
            const std::string_view name = names.spelling(each.name);
            if (!each.local && is_for_scenes(guide, name, each.kind == DeclaredName::macro))
                add_name(file, each, names, guide);
        }
    }

    void add_name(const EditedFile& file, const DeclaredName& each, const Names& names,
                  const LibraryFile& guide) {
        const std::string_view name = names.spelling(each.name);
        if (each.kind != DeclaredName::macro) {
            add({std::string(name), Suggestion::name, file_name(file), ""});
            return;
        }
        const LibraryMacro* const macro = find_macro(guide, name);
        add({std::string(name), Suggestion::macro, macro ? macro->form : file_name(file),
             macro ? macro->help : ""});
    }

    static std::string file_name(const EditedFile& file) {
        return file.path.substr(file.path.rfind('/') + 1);
    }

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
        const std::vector<NameId> blocks = blocks_around(*file, offset);
        result.add_block(blocks.empty() ? "" : workspace.names().spelling(blocks.front()));
        result.add_names(workspace, path);
        result.add_words();
    }
    return result.take();
}

}  // namespace candelabra
