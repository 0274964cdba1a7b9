// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/library_guide.h"

#include "base/order.h"
#include "text/ascii.h"
#include "text/loader.h"
#include "vocabulary/examples.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view comment_sign = "//";

std::string_view first_word(std::string_view text) {
    std::size_t length = 0;
    while (length < text.size() && in_name(text[length])) ++length;
    return text.substr(0, length);
}

std::string_view trimmed_line(std::string_view text) {
    const std::size_t first = std::min(text.find_first_not_of(" \t\r"), text.size());
    return text.substr(first);
}

void append_line(std::string& text, std::string_view line) {
    if (!text.empty() && !line.empty()) text += ' ';
    text += line;
}

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) lines.push_back(take_until(text, "\n"));
    return lines;
}

constexpr std::string_view example_sign = "e.g. ";

/// An entry of the comment at a file's beginning: one or several macros with what is said of them,
/// and their examples.
struct ListedEntry {
    std::string text;
    std::vector<std::string> examples = {};

    /// Adds a further line.
    void add(std::string_view line) {
        if (line.starts_with(example_sign))
            examples.emplace_back(line.substr(example_sign.size()));
        else
            append_line(examples.empty() ? text : examples.back(), line);
    }
};

/// The comment at the beginning of a file: its first paragraph, and the indented entries that list
/// the file's macros.
struct Header {
    std::string about;
    std::vector<ListedEntry> entries;
};

Header header_of(const std::vector<std::string_view>& lines) {
    constexpr std::size_t of_text = 1, of_entry = 3;
    Header header;
    bool about_ended = false;
    for (const std::string_view line : lines) {
        if (!line.starts_with(comment_sign)) break;
        const std::string_view comment = line.substr(comment_sign.size());
        const std::string_view text = trimmed_line(comment);
        const std::size_t indent = comment.size() - text.size();
        if (text.starts_with("SPDX")) continue;
        if (text.empty()) {
            about_ended = !header.about.empty();
        } else if (indent == of_entry) {
            header.entries.push_back({std::string(text)});
        } else if (indent > of_entry && !header.entries.empty()) {
            header.entries.back().add(text);
        } else if (indent == of_text && !about_ended) {
            append_line(header.about, text);
        }
    }
    return header;
}

/// The macro names at the beginning of an entry, and the text about them.
class HeaderEntry {
public:
    template <class IsMacro>
    HeaderEntry(std::string_view entry, IsMacro is_macro) {
        for (rest_ = entry; !rest_.empty();) {
            const std::string_view word = first_word(rest_);
            const std::string_view behind = rest_.substr(word.size());
            if (word.empty() || !is_macro(word)) return;
            names_.push_back(word);
            std::size_t length = 0;
            if (behind.starts_with('(')) length = std::min(behind.find(')'), behind.size() - 1) + 1;
            rest_ = trimmed_line(behind.substr(length));
        }
    }

    bool names(std::string_view name) const {
        return std::ranges::find(names_, name) != names_.end();
    }
    std::string_view text() const { return rest_; }

private:
    std::vector<std::string_view> names_;
    std::string_view rest_;
};

/// `#macro Name(A, B)` at the beginning of a line. Names that end in `_` are excluded.
struct Definition {
    std::string_view name;
    std::string form;
    std::size_t line;
};

std::vector<Definition> definitions_in(const std::vector<std::string_view>& lines) {
    constexpr std::string_view directive = "#macro ";
    std::vector<Definition> result;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string_view line = trimmed_line(lines[i]);
        if (!line.starts_with(directive)) continue;
        const std::string_view rest = trimmed_line(line.substr(directive.size()));
        const std::string_view name = first_word(rest);
        if (name.empty() || name.ends_with('_')) continue;
        std::string form(rest.substr(0, std::min(rest.find(')'), rest.size() - 1) + 1));
        for (std::size_t k = i + 1; k < lines.size() && !form.ends_with(')'); ++k) {
            const std::string_view more = trimmed_line(lines[k]);
            append_line(form, more.substr(0, std::min(more.find(')'), more.size() - 1) + 1));
        }
        result.push_back({name, std::move(form), i});
    }
    return result;
}

/// Returns the comment directly above a line.
ListedEntry comment_of(const std::vector<std::string_view>& lines, std::size_t line) {
    std::size_t first = line;
    while (first > 0 && lines[first - 1].starts_with("// ") &&
           lines[first - 1].find("----") == std::string_view::npos)
        --first;
    ListedEntry comment;
    for (; first < line; ++first)
        comment.add(trimmed_line(lines[first].substr(comment_sign.size())));
    return comment;
}

/// Gives the macro that of the examples in which it stands.
void choose_example(LibraryMacro& macro, const std::vector<std::string>& examples) {
    constexpr std::string_view arrow = " -> ";
    const auto found = std::ranges::find_if(
        examples, [&](const std::string& text) { return contains_word(text, macro.name); });
    if (found == examples.end()) return;
    const std::size_t end = std::min(found->find(arrow), found->size());
    macro.example = found->substr(0, end);
    macro.value = found->substr(std::min(end + arrow.size(), found->size()));
}

}  // namespace

LibraryFile library_file(std::string name, std::string_view text) {
    LibraryFile file;
    file.name = std::move(name);
    const std::vector<std::string_view> lines = lines_of(text);
    const Header header = header_of(lines);
    file.about = header.about;
    const std::vector<Definition> definitions = definitions_in(lines);
    const auto is_macro = [&](std::string_view word) {
        return std::ranges::find(definitions, word, &Definition::name) != definitions.end();
    };
    for (const Definition& each : definitions) {
        const bool known =
            std::ranges::find(file.macros, each.name, &LibraryMacro::name) != file.macros.end();
        if (known) continue;
        const ListedEntry comment = comment_of(lines, each.line);
        LibraryMacro macro{std::string(each.name), each.form, comment.text};
        choose_example(macro, comment.examples);
        for (const ListedEntry& entry : header.entries) {
            const HeaderEntry said(entry.text, is_macro);
            if (!said.names(each.name)) continue;
            macro.listed = true;
            if (!said.text().empty()) macro.help = said.text();
            choose_example(macro, entry.examples);
        }
        file.macros.push_back(std::move(macro));
    }
    // In a file that lists none, aids start with the file's name: Chars_Bar in chars.inc.
    const std::string own = file.name.substr(0, file.name.find('.')) + "_";
    if (std::ranges::none_of(file.macros, &LibraryMacro::listed))
        for (LibraryMacro& each : file.macros)
            each.listed = !same_letters(std::string_view(each.name).substr(0, own.size()), own);
    return file;
}

const LibraryMacro* find_macro(const LibraryFile& file, std::string_view name) {
    const auto found = std::ranges::find(file.macros, name, &LibraryMacro::name);
    return found == file.macros.end() ? nullptr : &*found;
}

LibraryGuide library_guide(const std::string& folder) {
    LibraryGuide guide;
    std::error_code none;
    const Reader read = disk_reader();
    for (const auto& entry : fs::directory_iterator(folder, none)) {
        if (entry.path().extension() != ".inc") continue;
        if (const auto text = read(entry.path().string()))
            guide.push_back(library_file(entry.path().filename().string(), *text));
    }
    sort_stably(guide, {}, &LibraryFile::name);
    return guide;
}

bool is_for_scenes(const LibraryFile& file, std::string_view name, bool is_macro) {
    if (name.ends_with('_') || name.ends_with("_Temp")) return false;
    const LibraryMacro* const macro = is_macro ? find_macro(file, name) : nullptr;
    return !is_macro || (macro && macro->listed);
}

}  // namespace candelabra
