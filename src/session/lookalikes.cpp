// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/lookalikes.h"

#include "text/ascii.h"
#include "text/message.h"
#include "text/printable.h"
#include "text/trimmed.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

std::optional<int> whole_number(std::string_view digits) {
    int value = 0;
    const char* const last = digits.data() + digits.size();
    const auto [end, problem] = std::from_chars(digits.data(), last, value);
    return problem == std::errc() && end == last ? std::optional(value) : std::nullopt;
}

/// A name with a number, such as P_Grain12A.
struct Numbered {
    std::string_view stem, digits, tail;

    explicit Numbered(std::string_view name) {
        std::size_t end = name.size();
        while (end > 0 && !is_digit(name[end - 1])) --end;
        tail = name.substr(end);
        std::size_t first = end;
        while (first > 0 && is_digit(name[first - 1])) --first;
        digits = name.substr(first, end - first);
        stem = name.substr(0, first);
    }
};

/// Adds `Water`, or `T_Wood1 to T_Wood35` one by one.
void add_names(std::string_view words, std::vector<std::string>& names) {
    const std::string_view first_word = take_until(words, " ");
    take_until(words, " ");  // to
    const Numbered first(first_word), last(words);
    int from = 0, to = -1;
    if (!words.empty() && first.stem == last.stem && first.tail == last.tail) {
        from = whole_number(first.digits).value_or(0);
        to = whole_number(last.digits).value_or(-1);
    }
    if (to < from) names.emplace_back(first_word);
    for (int i = from; i <= to; ++i) names.push_back(message(first.stem, i, first.tail));
}

/// Calls use(first, last) for each word of a scene, outside of comments and strings, until it
/// returns true.
template <class Use>
void for_words(std::string_view text, const Use& use) {
    for (std::size_t at = 0; at < text.size();) {
        const std::string_view rest = text.substr(at);
        std::size_t length = 1;
        if (rest.starts_with("//"))
            length = rest.find('\n');
        else if (rest.starts_with("/*"))
            length = std::min(rest.find("*/"), rest.size() - 2) + 2;
        else if (rest[0] == '"')
            length = std::min(rest.find('"', 1), rest.size() - 1) + 1;
        else if (in_name(rest[0])) {
            length = static_cast<std::size_t>(std::find_if_not(rest.begin(), rest.end(), in_name) -
                                              rest.begin());
            if (use(at, at + length)) return;
        }
        at += std::min(length, rest.size());
    }
}

}  // namespace

std::vector<std::string> only_alike(std::string_view text) {
    std::vector<std::string> names;
    while (!text.empty()) {
        std::string_view line = take_until(text, "\n");
        if (!line.starts_with(alike_mark)) continue;
        line.remove_prefix(alike_mark.size());
        while (!line.empty()) {
            const std::string_view one = trimmed(take_until(line, ",."), " ");
            if (!one.empty()) add_names(one, names);
        }
    }
    return names;
}

void review_lookalikes(const SourceStore& sources,
                       const std::function<bool(std::string_view path)>& in_library,
                       const std::string& povray, Diagnostics& diagnostics) {
    if (povray.empty()) return;
    std::map<std::string, std::string, std::less<>> alike;  // the file of each name
    const auto each_source = [&](bool of_library, const auto& use) {
        for (SourceId id = 0; id < sources.count(); ++id)
            if (in_library(sources.name(id)) == of_library) use(id);
    };
    each_source(true, [&](SourceId id) {
        const std::string file = fs::path(sources.name(id)).filename().string();
        std::error_code none;
        if (!fs::exists(fs::path(povray) / file, none)) return;
        for (const std::string& name : only_alike(sources.text(id))) alike.emplace(name, file);
    });
    bool warned = alike.empty();
    each_source(false, [&](SourceId id) {
        for_words(sources.text(id), [&](std::size_t first, std::size_t last) {
            if (warned) return true;
            const std::string_view word = sources.text(id).substr(first, last - first);
            const auto found = alike.find(word);
            if (found == alike.end()) return false;
            const Span span{id, static_cast<std::uint32_t>(first),
                            static_cast<std::uint32_t>(last)};
            diagnostics.add(warning(Fault::lookalike, span,
                                    message("`", word, "` of ", found->second,
                                            " has the colours of POV-Ray's and a pattern of its "
                                            "own"))
                                .with_help(message("--library ", printable(povray),
                                                   " takes POV-Ray's own include files")));
            return warned = true;
        });
    });
}

}  // namespace candelabra
