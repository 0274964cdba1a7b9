// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/ini.h"

#include "options/option_store.h"
#include "text/ascii.h"
#include "text/trimmed.h"

namespace candelabra {

namespace {

constexpr std::string_view blanks = " \t\r\n";

/// Returns the line without its comment; a `;` in quotes begins none.
std::string_view without_comment(std::string_view line) {
    char quote = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (quote)
            quote = line[i] == quote ? 0 : quote;
        else if (line[i] == '"' || line[i] == '\'')
            quote = line[i];
        else if (line[i] == ';')
            return line.substr(0, i);
    }
    return line;
}

/// Removes blanks around the first `=` and quotes around the value.
std::string as_argument(std::string_view line) {
    const std::size_t equals = line.find('=');
    if (equals == line.npos) return std::string(unquoted(line));
    const std::string_view value = trimmed(line.substr(equals + 1), blanks);
    // A declared string keeps its quotes, which mark it as a string.
    return std::string(trimmed(line.substr(0, equals), blanks)) + "=" +
           std::string(unquoted(value));
}

/// Splits a line of switches into words; quotes keep blanks in a word.
std::vector<std::string> words_of(std::string_view line) {
    std::vector<std::string> words;
    char quote = 0;
    bool inside = false;
    for (const char c : line) {
        const bool begins = !quote && (c == '"' || c == '\'');
        const bool ends = quote && c == quote;
        if (begins || ends) {
            quote = begins ? c : 0;
        } else if (!quote && (c == ' ' || c == '\t')) {
            inside = false;
        } else {
            if (!inside) words.emplace_back();
            inside = true;
            words.back() += c;
        }
    }
    return words;
}

bool is_switch(std::string_view line) {
    return !line.starts_with("--") && (line[0] == '+' || line[0] == '-');
}

}  // namespace

std::string_view unquoted(std::string_view value) {
    const bool quoted = value.size() >= 2 && (value.front() == '"' || value.front() == '\'') &&
                        value.back() == value.front();
    return quoted ? value.substr(1, value.size() - 2) : value;
}

std::optional<std::vector<IniLine>> ini_lines(std::string_view text, std::string_view section) {
    std::vector<IniLine> lines;
    bool taken = true, found = section.empty();
    int number = 0;
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // byte order mark of some editors
    while (!text.empty()) {
        const std::string_view line = trimmed(without_comment(take_until(text, "\n")), blanks);
        ++number;
        if (line.starts_with('[') && line.ends_with(']')) {
            taken = !section.empty() &&
                    same_letters(trimmed(line.substr(1, line.size() - 2), blanks), section);
            found |= taken;
        } else if (taken && !line.empty() && is_switch(line)) {
            for (std::string& word : words_of(line)) lines.push_back({number, std::move(word)});
        } else if (taken && !line.empty()) {
            lines.push_back({number, as_argument(line)});
        }
    }
    return found ? std::optional(std::move(lines)) : std::nullopt;
}

std::string ini_line(const std::string& option) {
    const auto says_it = [&](const std::string& line) {
        const auto read = ini_lines(line, {});
        return read && read->size() == 1 && read->front().option == option;
    };
    // After the sign of a switch, or around a value.
    const std::size_t equals = option.find('=');
    const std::size_t at = !option.empty() && is_switch(option) ? 1 : equals + 1;
    for (const char quote : {'"', '\''}) {
        if (says_it(option)) return option;
        const std::string quoted = option.substr(0, at) + quote + option.substr(at) + quote;
        if (says_it(quoted)) return quoted;
    }
    return option;
}

std::optional<IniName> ini_name(std::string_view argument) {
    IniName name;
    if (argument.ends_with(']')) {
        const std::size_t open = argument.rfind('[');
        if (open == argument.npos) return std::nullopt;
        name.section = trimmed(argument.substr(open + 1, argument.size() - open - 2), blanks);
        argument = argument.substr(0, open);
    }
    constexpr std::string_view ending = ".ini";
    if (argument.size() <= ending.size() ||
        !same_letters(argument.substr(argument.size() - ending.size()), ending))
        return std::nullopt;
    name.file = argument;
    return name;
}

}  // namespace candelabra
