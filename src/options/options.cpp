// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/declared_values.h"
#include "options/options.h"

#include "options/confinement.h"
#include "options/ini.h"
#include "options/option_table.h"
#include "text/ascii.h"
#include "text/message.h"
#include "text/nearest.h"
#include "text/printable.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace candelabra {

namespace {

bool starts_with_letters(std::string_view text, std::string_view letters) {
    return same_letters(text.substr(0, letters.size()), letters);
}

/// Returns the longest switch that the text after the sign begins with, or null.
const OptionRow* find_switch(std::string_view text) {
    const OptionRow* best = nullptr;
    for (const OptionRow& row : option_table())
        if (!row.letters.empty() && starts_with_letters(text, row.letters) &&
            (!best || row.letters.size() > best->letters.size()))
            best = &row;
    return best;
}

const OptionRow* find_named(std::string_view OptionRow::*name, std::string_view text) {
    for (const OptionRow& row : option_table())
        if (!(row.*name).empty() && same_letters(row.*name, text)) return &row;
    return nullptr;
}

/// Returns the keyword with the letters that the table has: Bits_Per_Colour is Bits_Per_Color.
std::string usual_spelling(std::string_view keyword) {
    std::string name = lower_case(keyword);
    for (const auto& [from, to] : {std::pair{"colour", "color"}, std::pair{"grey", "gray"}})
        if (const std::size_t at = name.find(from); at != name.npos)
            name.replace(at, std::string_view(from).size(), to);
    return name;
}

/// Whether a keyword is on; a number other than 0 says so in POV-Ray.
std::optional<bool> switched(std::string_view text) {
    if (const auto on = truth(text)) return on;
    const std::optional<double> value = number(text);
    return value ? std::optional(*value != 0) : std::nullopt;
}

/// Returns the row of a long option. Every keyword is one, too: `--output-file-name` is
/// `Output_File_Name`.
const OptionRow* find_long(std::string_view name) {
    if (const OptionRow* row = find_named(&OptionRow::word, name)) return row;
    std::string keyword(name);
    std::ranges::replace(keyword, '-', '_');
    return keyword.empty() ? nullptr : find_named(&OptionRow::keyword, usual_spelling(keyword));
}

bool keyword_form(std::string_view argument) {
    const std::size_t equals = argument.find('=');
    if (equals == std::string_view::npos || equals == 0) return false;
    return std::ranges::all_of(argument.substr(0, equals), in_name);
}

/// Whether an empty value means that there is no file or command.
bool may_be_empty(const OptionRow& row) {
    return row.parameter == "command" || row.keyword.ends_with("_File");
}

bool names_a_scene(std::string_view argument) {
    return argument.size() > 4 && same_letters(argument.substr(argument.size() - 4), ".pov");
}

/// Whether the argument is the scene or an INI file rather than the value of an unknown option.
bool names_a_file(std::string_view argument) {
    return names_a_scene(argument) || ini_name(argument);
}

/// Returns the options that an argument may have been meant as, in its own form: "--seed", "+WT",
/// "Width=".
std::string meant(std::string_view argument) {
    std::vector<std::string> texts;
    for (const OptionRow& row : option_table()) {
        if (row.unoffered != Unoffered::no) continue;
        if (!row.letters.empty() && argument.size() < 5)
            texts.push_back(message(argument.substr(0, 1), row.letters));
        if (!row.keyword.empty()) texts.push_back(message(row.keyword, "="));
        if (!long_name(row).empty()) texts.push_back(message("--", long_name(row)));
    }
    std::string_view word = argument.substr(0, argument.find('='));
    const std::string with_equals = message(word, "=");
    const std::vector<std::string_view> names(texts.begin(), texts.end());
    const std::string found = nearest(
        argument.size() > word.size() && !argument.starts_with('-') ? with_equals : word, names);
    return found.empty() ? "" : message("did you mean `", found, "`?");
}

/// Nesting of INI files, and how often files may be named in all: those that name themselves
/// several times would be read without end.
constexpr int max_ini_files = 10, max_ini_names = 1000;
/// Samples of each pixel of a draft: the fewest that tell the denoiser how noisy a pixel is.
constexpr int draft_samples = 4;

class OptionReader {
public:
    OptionReader(std::span<const std::string_view> arguments, Diagnostics& diagnostics,
                 const Reader& read, Options usual)
        : arguments_(arguments),
          diagnostics_(diagnostics),
          read_(read),
          options_(std::move(usual)) {}

    Options read(const std::string& settings) {
        if (!settings.empty()) {
            const IniName ini = ini_name(settings).value_or(IniName{settings, {}});
            // A file in the current folder may have come with a scene.
            if (settings.find('/') == settings.npos)
                read_confined(settings, ini);
            else
                read_ini(settings, ini, read_);
        }
        permitted_ = permissions();
        while (next_ < arguments_.size()) read_one(arguments_[next_++]);
        const bool bounded =
            options_.render.samples > 0 || options_.render.noise > 0 || options_.time;
        if (options_.draft && !bounded) options_.render.samples = draft_samples;
        return std::move(options_);
    }

private:
    void fail(std::string_view argument, const std::string& rule, const std::string& help = {}) {
        refuse({argument, true, {}, where_}, diagnostics_, rule, help);
    }

    void read_one(std::string_view argument) {
        if (only_files_) return read_scene(argument);
        if (argument == "--")
            only_files_ = true;
        else if (argument.starts_with("--"))
            read_long(argument);
        else if (argument.size() > 1 && (argument[0] == '+' || argument[0] == '-'))
            read_switch(argument);
        else if (keyword_form(argument))
            read_keyword(argument);
        else
            read_scene(argument);
    }

    void read_scene(std::string_view argument) {
        if (argument.empty()) return fail(argument, "a file name cannot be empty");
        if (const auto ini = only_files_ ? std::nullopt : ini_of(argument))
            return read_named(argument, *ini);
        if (const auto broken = broken_by(std::string(argument)))
            return fail(argument, broken->rule, broken->help);
        if (bare_scene_)
            return fail(argument,
                        message("only one scene can be rendered at a time, and there is already `",
                                printable(*options_.scene), "`"));
        bare_scene_ = true;
        options_.scene = argument;
        options_.given.push_back({nullptr, message("Input_File_Name=", argument)});
    }

    /// Reads an INI file that the command line or another INI file names.
    void read_named(std::string_view argument, const IniName& ini) {
        if (const auto broken = broken_by(ini.file))
            return fail(argument, broken->rule, broken->help);
        read_confined(argument, ini);
    }

    void read_included(std::string_view argument, std::string_view file) {
        if (const auto ini = ini_of(file)) return read_named(argument, *ini);
        fail(argument, "names no INI file", "Include_Ini=file.ini");
    }

    /// Returns the name of an INI file. As in POV-Ray, a bare word may lack the extension if such a
    /// file exists.
    std::optional<IniName> ini_of(std::string_view argument) const {
        if (auto named = ini_name(argument)) return named;
        const std::size_t section = argument.ends_with(']') ? argument.rfind('[') : argument.npos;
        const std::string_view word = argument.substr(0, section);
        const bool bare = word.find_last_of("./") == word.npos;
        const auto ini = ini_name(
            message(word, ".ini", section == argument.npos ? "" : argument.substr(section)));
        return bare && ini && read_ && read_.holds(ini->file) ? ini : std::nullopt;
    }

    /// Returns the permissions anywhere on the command line, added to those of the settings.
    Options permissions() const {
        Options result = options_;
        for (std::size_t i = 0; i < arguments_.size() && arguments_[i] != "--"; ++i)
            for (const auto& [word, folders] : {std::pair{"--allow-read", &result.readable},
                                                std::pair{"--allow-write", &result.writable}}) {
                const std::string with_equals = message(word, "=");
                if (arguments_[i] == word && i + 1 < arguments_.size())
                    folders->emplace_back(arguments_[i + 1]);
                else if (arguments_[i].starts_with(with_equals))
                    folders->emplace_back(arguments_[i].substr(with_equals.size()));
            }
        return result;
    }

    /// Returns the rule that a file breaks if it is named by an INI file that may not be the user's
    /// own.
    std::optional<BrokenRule> broken_by(const std::string& path) const {
        BrokenRule broken = confined_ ? confined_->of_read(path) : BrokenRule();
        return broken.rule.empty() ? std::nullopt : std::optional(std::move(broken));
    }

    /// Reads an INI file that may have come with a scene. INI files that it names must lie below
    /// its folder, too.
    void read_confined(std::string_view argument, const IniName& ini) {
        const bool outermost = !confined_;
        if (outermost) {
            Options outside = options_;
            outside.readable = permitted_.readable;
            outside.writable = permitted_.writable;
            confined_.emplace(ini.file, outside);
        }
        // Only the outermost file is named by the user.
        read_ini(argument, ini, outermost ? read_ : confined_->reader(read_));
        if (outermost) confined_.reset();
    }

    void read_ini(std::string_view argument, const IniName& ini, const Reader& reader) {
        if (++ini_names_ > max_ini_names)
            return fail(argument,
                        message("INI files are named more than ", max_ini_names, " times"));
        const std::optional<std::string> text = reader ? reader(ini.file) : std::nullopt;
        if (!text) return fail(argument, "there is no such file that can be read");
        if (depth_ >= max_ini_files)
            return fail(argument,
                        message("INI files name each other more than ", max_ini_files, " deep"));
        const auto lines = ini_lines(*text, ini.section);
        if (!lines) return fail(argument, message("the file has no section [", ini.section, "]"));
        const std::string outer = std::exchange(where_, {});
        const auto after = std::exchange(arguments_, {});
        const std::size_t next = std::exchange(next_, 0);
        ++depth_;
        for (const IniLine& line : *lines) {
            if (ini_names_ > max_ini_names) break;
            where_ = message(ini.file, ":", line.number);
            read_one(line.option);
        }
        --depth_;
        arguments_ = after;
        next_ = next;
        where_ = outer;
    }

    void accept(const OptionRow& row, const Given& given) {
        const BrokenRule broken = confined_ ? confined_->of_option(row, given) : BrokenRule();
        if (!broken.rule.empty()) return refuse(given, diagnostics_, broken.rule, broken.help);
        const std::size_t before = diagnostics_.error_count();
        apply(row, options_, given, diagnostics_);
        if (confined_ && confined_->exceeded(options_))
            return refuse(given, diagnostics_, Confinement::limit_rule());
        if (row.store == store::preset) read_preset(given);
        options_.strange_names |= confined_ && row.touches == Touches::writes;
        if (diagnostics_.error_count() > before || row.unoffered != Unoffered::no) return;
        // The user may name a header where the scene reads nothing.
        if (row.store == store::header && !confined_) options_.readable.push_back(*given.value);
        if (row.store == store::create_ini || row.word.starts_with("allow-")) return;
        const std::string value = given.value.value_or(given.on ? "on" : "off");
        options_.given.push_back({&row, line_of(row, given, value)});
    }

    void read_preset(const Given& given) {
        const std::optional<std::string> text = read_ ? read_(*given.value) : std::nullopt;
        if (!text) return refuse(given, diagnostics_, "there is no such file that can be read");
        std::string problem;
        const auto set = preset(*text, problem);
        if (!set) return refuse(given, diagnostics_, problem, "{\"Height\": 3, \"Kind\": \"fir\"}");
        options_.declares.insert(options_.declares.end(), set->begin(), set->end());
    }

    /// Returns the option as a line of an INI file.
    static std::string line_of(const OptionRow& row, const Given& given, const std::string& value) {
        if (row.keyword.empty())
            return message("--", row.word, given.value ? message("=", value) : std::string());
        if (row.takes == Takes::sign_and_value && given.value)
            return message(given.on ? "+" : "-", row.letters, value);
        return message(row.keyword, "=", value);
    }

    /// The value without quotes around it. Lines of INI files have lost theirs before.
    std::string_view plain(std::string_view value) const {
        return depth_ > 0 ? value : unquoted(value);
    }

    void read_switch(std::string_view argument) {
        const std::string_view text = argument.substr(1);
        if (same_letters(text, "h")) {  // the shortest switch for help in POV-Ray
            options_.task = Task::help;
            return;
        }
        if (argument == "-version" || argument == "-help")  // of POV-Ray for Unix
            return read_long(message("-", argument));
        const OptionRow* row = find_switch(text);
        if (find_named(&OptionRow::word, text) || !row)
            return fail(argument, "there is no such option", help_for(argument));
        std::optional<std::string> value;
        if (text.size() > row->letters.size()) value = plain(text.substr(row->letters.size()));
        if (row->takes == Takes::sign && value)
            return fail(argument, "there is no such option", help_for(argument));
        if (row->takes == Takes::value && !value && next_is_value()) value = arguments_[next_++];
        if (row->takes == Takes::value && (!value || value->empty()))
            return fail(argument, message("needs a value: `", argument, row->parameter, "`"));
        accept(*row, {argument, argument[0] == '+' || row->takes == Takes::value, value, where_});
    }

    /// Whether the next argument is no option: a number may have a sign.
    bool next_is_value() const {
        if (next_ >= arguments_.size()) return false;
        const std::string_view next = arguments_[next_];
        return !next.starts_with('-') && !next.starts_with('+') ? !next.empty()
                                                                : number(next).has_value();
    }

    std::string help_for(std::string_view argument) {
        if (find_named(&OptionRow::word, argument.substr(1)))
            return message("did you mean `--", argument.substr(1), "`?");
        return meant(argument);
    }

    void read_keyword(std::string_view argument) {
        const std::size_t equals = argument.find('=');
        const OptionRow* row =
            find_named(&OptionRow::keyword, usual_spelling(argument.substr(0, equals)));
        if (!row && names_a_scene(argument)) return read_scene(argument);
        if (!row) {
            const std::string near = meant(argument);
            return fail(
                argument, "there is no such keyword",
                near.empty() ? message("if it is a file: `./", printable(argument), "`") : near);
        }
        const std::string text(plain(argument.substr(equals + 1)));
        if (row->takes == Takes::value) {
            if (text.empty() && !may_be_empty(*row)) return without_value(argument);
            if (row->store == store::include_ini) return read_included(argument, text);
            return accept(*row, {argument, true, text, where_});
        }
        const std::optional<bool> on = switched(text);
        if (!on) return fail(argument, "the value must be on or off");
        accept(*row, {argument, *on, {}, where_});
    }

    /// Warns, since POV-Ray's own INI files have keywords without values, to be filled in; an error
    /// on the command line.
    void without_value(std::string_view argument) {
        if (where_.empty()) return fail(argument, "needs a value");
        diagnostics_.add(
            warning(Fault::option, {},
                    message(where_, ": `", printable(argument), "` has no value and is ignored")));
    }

    void read_long(std::string_view argument) {
        const std::size_t equals = argument.find('=');
        const OptionRow* row =
            find_long(argument.substr(2, equals == std::string_view::npos ? equals : equals - 2));
        if (!row) {
            fail(argument, "there is no such option", meant(argument));
            // Skips its value, which would otherwise be taken for a scene.
            if (equals == argument.npos && next_is_value() && !names_a_file(arguments_[next_]))
                ++next_;
            return;
        }
        Given given{argument, true, {}, where_};
        if (equals != std::string_view::npos) given.value = argument.substr(equals + 1);
        if (row->takes == Takes::sign || (row->takes == Takes::sign_and_value && given.value)) {
            // A keyword that is on or off: --output-alpha, --output-alpha=off.
            const bool sign = row->takes == Takes::sign;
            const std::optional<bool> on = !given.value ? true
                                           : sign       ? switched(*given.value)
                                                        : truth(*given.value);
            if (!on && sign) return fail(argument, "the value must be on or off");
            if (on) given.value.reset();
            given.on = on.value_or(true);
        }
        if (given.value && row->takes == Takes::nothing) return fail(argument, "takes no value");
        const bool settings = row->takes == Takes::value_and_settings;
        const bool wants_value = row->takes == Takes::value || settings;
        if (!given.value && wants_value && next_ < arguments_.size())
            given.value = arguments_[next_++];
        if (given.value && settings) *given.value += following_settings();
        if (!given.value && row->takes == Takes::maybe_words)
            given.value = following_words(row->store == store::help);
        if (wants_value && (!given.value || given.value->empty()))
            return fail(argument,
                        message("needs a value: `--", long_name(*row), " ", row->parameter, "`"));
        accept(*row, given);
    }

    /// Returns the arguments `name=values` up to the next option, each after a blank. A single
    /// value, such as Clock=0.5, may be that of an option.
    std::string following_settings() {
        std::string words;
        for (; next_ < arguments_.size(); ++next_) {
            const std::string_view word = arguments_[next_];
            const std::size_t equals = word.find('=');
            if (word.starts_with('-') || word.starts_with('+') || equals == word.npos) break;
            const bool several = word.find("..") != word.npos || word.find(',') != word.npos;
            if (!several &&
                find_named(&OptionRow::keyword, usual_spelling(word.substr(0, equals))))
                break;
            words += message(' ', word);
        }
        return words;
    }

    /// Returns the arguments up to the next option, separated by blanks. `option_first`: the first
    /// may be an option, the topic of help.
    std::optional<std::string> following_words(bool option_first) {
        std::string words;
        for (; next_ < arguments_.size(); ++next_) {
            const std::string_view word = arguments_[next_];
            const bool option = word.starts_with('-') || word.starts_with('+');
            if (option && !(option_first && words.empty())) break;
            words += message(words.empty() ? "" : " ", word);
        }
        return words.empty() ? std::nullopt : std::optional(words);
    }

    std::span<const std::string_view> arguments_;
    Diagnostics& diagnostics_;
    const Reader& read_;
    Options options_;
    std::string where_;  ///< place in an INI file
    int depth_ = 0;      ///< nesting of INI files
    int ini_names_ = 0;  ///< how often INI files were named
    std::size_t next_ = 0;
    bool only_files_ = false;
    bool bare_scene_ = false;
    Options permitted_;                    ///< permissions of the user, for folders
    std::optional<Confinement> confined_;  ///< in an INI file that is not the user's own
};

}  // namespace

Options read_options(std::span<const std::string_view> arguments, Diagnostics& diagnostics,
                     const Reader& read, const std::string& settings, Options usual) {
    return OptionReader(arguments, diagnostics, read, std::move(usual)).read(settings);
}

}  // namespace candelabra
