// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/completion.h"

#include "options/option_help.h"
#include "options/option_table.h"
#include "text/message.h"
#include "text/shell_word.h"

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

std::string for_bash() {
    std::string words, paths;
    for (const Spelling& each : spellings()) {
        words += message(each.text, ' ');
        if (each.is_path && each.apart) paths += message(paths.empty() ? "" : "|", each.text);
    }
    return message(
        "# SPDX-License-Identifier: GPL-3.0-or-later\n"
        "# Completion of candelabra for bash.\n"
        "_candelabra() {\n"
        "    local word=\"${COMP_WORDS[COMP_CWORD]}\" before=\"${COMP_WORDS[COMP_CWORD-1]}\"\n"
        "    local words=",
        shell_quoted(words),
        "\n"
        "    COMPREPLY=()\n"
        "    case \"$before\" in\n"
        "        ",
        paths,
        ") mapfile -t COMPREPLY < <(compgen -f -- \"$word\"); return ;;\n"
        "    esac\n"
        "    case \"$word\" in\n"
        "        [-+]*|[A-Z]*) mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\") ;;\n"
        "    esac\n"
        "    mapfile -t -O \"${#COMPREPLY[@]}\" COMPREPLY < <(\n"
        "        compgen -f -X '!*.@(pov|ini|exr)' -- \"$word\"\n"
        "        compgen -d -S / -- \"$word\"\n"
        "        [ \"$COMP_CWORD\" -eq 1 ] && compgen -W 'new merge develop share light fmt lsp' "
        "-- "
        "\"$word\")\n"
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

std::string for_zsh() {
    std::string text =
        "#compdef candelabra\n"
        "# SPDX-License-Identifier: GPL-3.0-or-later\n"
        "# Completion of candelabra for zsh.\n"
        "_arguments \\\n";
    for (const Spelling& each : spellings()) {
        if (each.text.ends_with('=')) continue;  // keywords are completed as words below
        const std::string_view action = each.is_path  ? ":file:_files"
                                        : each.valued ? ":value: "
                                                      : "";
        text += message(
            "  ",
            shell_quoted(message(each.text,
                                 each.apart    ? "="
                                 : each.valued ? "-"
                                               : "",
                                 '[', harmless_for_zsh(first_clause(each.help)), ']', action)),
            " \\\n");
    }
    return text + "  '*:scene:_files -g \"*.(pov|ini|state.exr)(-.)\"'\n";
}

std::string for_fish() {
    std::string text =
        "# SPDX-License-Identifier: GPL-3.0-or-later\n"
        "# Completion of candelabra for fish.\n"
        "complete -c candelabra -f\n"
        "complete -c candelabra -k -a '(__fish_complete_suffix .pov)'\n"
        "complete -c candelabra -k -a '(__fish_complete_suffix .ini)'\n"
        "complete -c candelabra -n __fish_is_first_arg -a new -d 'writes a scene to begin with'\n"
        "complete -c candelabra -n __fish_is_first_arg -a merge -d 'joins the states of shards'\n"
        "complete -c candelabra -n __fish_is_first_arg -a develop -d 'develops light in OpenEXR "
        "files'\n"
        "complete -c candelabra -n __fish_is_first_arg -a share -d 'makes a page to share'\n"
        "complete -c candelabra -n __fish_is_first_arg -a fmt -d 'lays out scene files'\n"
        "complete -c candelabra -n __fish_is_first_arg -a lsp -d 'helps an editor with scenes'\n";
    for (const Spelling& each : spellings()) {
        const std::string help = shell_quoted(first_clause(each.help));
        if (each.text.starts_with("--"))
            text += message("complete -c candelabra -l ", each.text.substr(2),
                            each.is_path  ? " -rF"
                            : each.valued ? " -x"
                                          : "",
                            " -d ", help, '\n');
        else
            text +=
                message("complete -c candelabra -a ", shell_quoted(each.text), " -d ", help, '\n');
    }
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
