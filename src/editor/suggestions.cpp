// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/suggestions.h"

#include "bind/object_functions.h"
#include "editor/hover.h"
#include "editor/library_guide.h"
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

    /// Adds the fields of the block's item, and its kinds.
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

    /// Adds words that a block accepts besides those of its item, such as those common to all
    /// objects or textures.
    void add_common_words(std::string_view block) {
        for (const auto& [blocks, words] : common_words)
            if (names_word(blocks, block) || (blocks == object_blocks && is_shape(block)))
                for (std::string_view rest = words; !rest.empty();) add_word(take_until(rest, " "));
    }

    /// Adds words outside of all blocks: the shapes, and the other parts of a scene.
    void add_statements() {
        for (std::string_view rest = statements; !rest.empty();) add_word(take_until(rest, " "));
        add_shapes();
    }

    void add_shapes() {
        for (const ItemGroup& group : catalogue())
            if (group.name == "Shapes")
                for (const ItemInfo* item : group.items) add_item(*item, group.block);
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
    static constexpr std::string_view object_blocks = "object union merge intersection difference";
    static constexpr std::string_view moves = "translate rotate scale matrix transform";
    static constexpr std::pair<std::string_view, std::string_view> common_words[] = {
        {object_blocks,
         "pigment finish texture normal interior material translate rotate scale matrix transform "
         "no_shadow no_image no_reflection no_radiosity no_luminaire hollow inverse "
         "double_illuminate clipped_by bounded_by interior_texture uv_mapping photons"},
        {"texture", "pigment normal finish texture_map uv_mapping no_bump_scale"},
        {"material", "texture interior interior_texture"},
        {"pigment",
         "rgb rgbt rgbf rgbft srgb color_map pigment_map uv_mapping turbulence warp quick_color"},
        {"normal", "normal_map slope_map bump_size uv_mapping turbulence warp no_bump_scale"},
        {"texture pigment normal camera light_source material sky_sphere", moves},
    };
    static constexpr std::string_view statements =
        "camera light_source object union difference intersection merge plane sky_sphere "
        "background "
        "fog global_settings light_group";

    static bool names_word(std::string_view list, std::string_view word) {
        while (!list.empty())
            if (take_until(list, " ") == word) return true;
        return false;
    }

    static bool is_shape(std::string_view block) {
        for (const ItemGroup& group : catalogue())
            if (group.name == "Shapes")
                for (const ItemInfo* item : group.items)
                    if (item->name == block) return true;
        return false;
    }

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

bool gathers_objects(std::string_view block) {
    return block == "object" || block == "union" || block == "merge" || block == "intersection" ||
           block == "difference" || block == "light_group";
}

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
        for (const NameId block : blocks) {
            result.add_block(workspace.names().spelling(block));
            result.add_common_words(workspace.names().spelling(block));
        }
        if (blocks.empty()) result.add_statements();
        if (!blocks.empty() && gathers_objects(workspace.names().spelling(blocks.front())))
            result.add_shapes();
        result.add_names(workspace, path);
        result.add_words();
    }
    return result.take();
}

}  // namespace candelabra
