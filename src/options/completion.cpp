// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/completion.h"

#include "options/option_help.h"
#include "options/option_table.h"
#include "options/subcommands.h"
#include "text/message.h"
#include "text/shell_word.h"

#include <algorithm>
#include <string>
#include <vector>

namespace candelabra {

namespace {

/// One spelling of an option.
struct Spelling {
    std::string text;  ///< "--samples", "+W", "Width="
    std::string help;
    bool valued = false;  ///< a value must follow
    bool apart = false;   ///< the value is a separate word
    bool is_path = false;
};

bool takes_path(const OptionRow& row) {
    return row.parameter == "file" || row.parameter == "folder";
}

std::vector<Spelling> spellings() {
    std::vector<Spelling> all;
    for (const OptionRow& row : option_table()) {
        if (row.unoffered != Unoffered::no) continue;
        const std::string help = manual_entry(row).help;
        const bool valued = row.takes == Takes::value || row.takes == Takes::value_and_settings;
        const bool path = takes_path(row);
        if (!row.letters.empty())
            all.push_back({message('+', row.letters), help, valued, false, path});
        if (row.takes == Takes::sign || row.takes == Takes::sign_and_value)
            if (!row.letters.empty())
                all.push_back({message('-', row.letters), help, false, false, false});
        if (!row.keyword.empty())
            all.push_back({message(row.keyword, '='), help, true, false, path});
        if (const std::string name = long_name(row); !name.empty())
            all.push_back({message("--", name), help, valued, valued, path});
    }
    return all;
}

/// The options of a subcommand as they are written, each before its value.
std::vector<Spelling> spellings_of(const Subcommand& command) {
    std::vector<Spelling> all;
    for (const SubcommandOption& option : options_of(command)) {
        const bool valued = !option.parameter.empty(), path = option.parameter == "file";
        all.push_back({std::string(option.name), std::string(option.help), valued, valued, path});
        if (option.name == "--output")
            all.push_back({"-o", std::string(option.help), true, true, true});
    }
    return all;
}

/// Words, each before a blank, and to `paths` those before a file, divided by bars.
std::string words_of(const std::vector<Spelling>& all, std::string& paths) {
    std::string words;
    for (const Spelling& each : all) {
        words += message(each.text, ' ');
        if (each.is_path && each.apart) paths += message(paths.empty() ? "" : "|", each.text);
    }
    return words;
}

std::string for_bash() {
    std::string paths, names, cases;
    const std::string words = words_of(spellings(), paths);
    for (const Subcommand& command : subcommands()) {
        names += message(names.empty() ? "" : " ", command.name);
        const std::string own = words_of(spellings_of(command), paths);
        cases += message("        ", command.name, ") words=", shell_quoted(own),
                         command.takes_run ? "\"$words\"" : "", " files='!*.@(", command.endings,
                         ")' ;;\n");
    }
    return message(
        "# SPDX-License-Identifier: GPL-3.0-or-later\n"
        "# Completion of candelabra for bash.\n"
        "_candelabra() {\n"
        "    local word=\"${COMP_WORDS[COMP_CWORD]}\" before=\"${COMP_WORDS[COMP_CWORD-1]}\"\n"
        "    local files='!*.@(pov|ini|exr)' words=",
        shell_quoted(words),
        "\n"
        "    COMPREPLY=()\n"
        "    [ \"$COMP_CWORD\" -gt 1 ] && case \"${COMP_WORDS[1]}\" in\n",
        cases,
        "    esac\n"
        "    case \"$before\" in\n"
        "        ",
        paths,
        ") mapfile -t COMPREPLY < <(compgen -f -- \"$word\"); return ;;\n"
        "    esac\n"
        "    case \"$word\" in\n"
        "        [-+]*|[A-Z]*) mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\") ;;\n"
        "    esac\n"
        "    mapfile -t -O \"${#COMPREPLY[@]}\" COMPREPLY < <(\n"
        "        compgen -f -X \"$files\" -- \"$word\"\n"
        "        compgen -d -S / -- \"$word\"\n"
        "        [ \"$COMP_CWORD\" -eq 1 ] && compgen -W ",
        shell_quoted(names),
        " -- \"$word\")\n"
        "    [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == */ ]] && compopt -o nospace\n"
        "    return 0\n"
        "}\n"
        "shopt -s extglob\n"
        "complete -F _candelabra candelabra\n");
}

/// Escapes the characters that _arguments would interpret.
std::string harmless_for_zsh(const std::string& help) {
    std::string result;
    for (const char c : help) {
        if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
        result += c;
    }
    return result;
}

/// Arguments of _arguments for options, one a line.
std::string for_arguments_of_zsh(const std::vector<Spelling>& all) {
    std::string text;
    for (const Spelling& each : all) {
        if (each.text.ends_with('=')) continue;  // keywords are completed as words
        const std::string_view action = each.is_path  ? ":file:_files"
                                        : each.valued ? ":value: "
                                                      : "";
        const bool is_long = each.text.starts_with("--");
        text += message(
            "    ",
            shell_quoted(message(each.text,
                                 each.apart    ? (is_long ? "=" : "")
                                 : each.valued ? "-"
                                               : "",
                                 '[', harmless_for_zsh(first_clause(each.help)), ']', action)),
            "\n");
    }
    return text;
}

std::string for_zsh() {
    std::string names, cases;
    for (const Subcommand& command : subcommands()) {
        names += message(
            "    ",
            shell_quoted(message(command.name, ':', harmless_for_zsh(std::string(command.help)))),
            "\n");
        cases += message("    ", command.name, ")\n      own=(\n",
                         for_arguments_of_zsh(spellings_of(command)), "      )\n", "      files='",
                         command.endings, "'\n", command.takes_run ? "" : "      of_run=()\n",
                         "      ;;\n");
    }
    return message(
        "#compdef candelabra\n"
        "# SPDX-License-Identifier: GPL-3.0-or-later\n"
        "# Completion of candelabra for zsh.\n"
        "local -a of_run own names\n"
        "local files='pov|ini|state.exr'\n"
        "of_run=(\n",
        for_arguments_of_zsh(spellings()),
        ")\n"
        "names=(\n",
        names,
        ")\n"
        "(( CURRENT == 2 )) && _describe subcommand names\n"
        "if (( CURRENT > 2 )); then\n"
        "  case $words[2] in\n",
        cases,
        "  esac\n"
        "  if (( ${names[(I)$words[2]:*]} )); then\n"
        "    shift words\n"
        "    (( CURRENT-- ))\n"
        "  fi\n"
        "fi\n"
        "_arguments $own $of_run \"*:file:_files -g '*.($files)(-.)'\"\n");
}

/// A line that completes one option, where `condition` holds.
std::string line_for_fish(const Spelling& each, const std::string& condition) {
    const std::string help = shell_quoted(first_clause(each.help));
    const std::string begin = message("complete -c candelabra", condition);
    const std::string_view value = each.is_path ? " -rF" : each.valued ? " -x" : "";
    if (each.text.starts_with("--"))
        return message(begin, " -l ", each.text.substr(2), value, " -d ", help, '\n');
    if (each.text == "-o") return message(begin, " -s o", value, " -d ", help, '\n');
    return message(begin, " -a ", shell_quoted(each.text), " -d ", help, '\n');
}

std::string for_fish() {
    std::string text =
        "# SPDX-License-Identifier: GPL-3.0-or-later\n"
        "# Completion of candelabra for fish.\n"
        "complete -c candelabra -f\n"
        "complete -c candelabra -k -a '(__fish_complete_suffix .pov)'\n"
        "complete -c candelabra -k -a '(__fish_complete_suffix .ini)'\n";
    for (const Subcommand& command : subcommands()) {
        text += message("complete -c candelabra -n __fish_is_first_arg -a ", command.name, " -d ",
                        shell_quoted(command.help), '\n');
        const std::string within = message(" -n '__fish_seen_subcommand_from ", command.name, "'");
        for (std::string_view left = command.endings; !left.empty();) {
            const std::string_view ending = left.substr(0, left.find('|'));
            text += message("complete -c candelabra", within, " -k -a '(__fish_complete_suffix .",
                            ending, ")'\n");
            left.remove_prefix(std::min(left.size(), ending.size() + 1));
        }
        for (const Spelling& each : spellings_of(command)) text += line_for_fish(each, within);
    }
    for (const Spelling& each : spellings()) text += line_for_fish(each, "");
    return text;
}

}  // namespace

std::optional<std::string> completion(std::string_view shell) {
    if (shell == "bash") return for_bash();
    if (shell == "zsh") return for_zsh();
    if (shell == "fish") return for_fish();
    return std::nullopt;
}

}  // namespace candelabra
