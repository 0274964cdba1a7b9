// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/lamp_names.h"

#include "text/ascii.h"
#include "text/message.h"
#include "text/nearest.h"
#include "text/printable.h"

#include <algorithm>
#include <charconv>
#include <system_error>
#include <utility>

namespace candelabra {

namespace {

/// The numbers in `17` or `0..99`: the first and the last.
std::optional<std::pair<std::uint32_t, std::uint32_t>> numbers_in(std::string_view text) {
    const auto number = [](std::string_view digits) -> std::optional<std::uint32_t> {
        std::uint32_t value = 0;
        const char* const end = digits.data() + digits.size();
        const auto read = std::from_chars(digits.data(), end, value);
        return read.ec == std::errc() && read.ptr == end ? std::optional(value) : std::nullopt;
    };
    const std::size_t dots = text.find("..");
    const auto first = number(text.substr(0, dots));
    const auto last = dots == text.npos ? first : number(text.substr(dots + 2));
    if (!first || !last || *last < *first) return std::nullopt;
    return std::pair(*first, *last);
}

}  // namespace

LampNames::LampNames(const LampList& lamps) : lamps_(&lamps) {
    for (std::size_t i = 0; i < lamps.groups().size(); ++i)
        groups_.try_emplace(lamps.groups()[i].name, i);
}

std::optional<std::vector<std::uint32_t>> LampNames::chosen(std::string_view name,
                                                            Diagnostics& diagnostics) const {
    std::vector<std::uint32_t> places;
    if (name == "*") {
        for (std::uint32_t place = 0; place < lamps_->size(); ++place) places.push_back(place);
        return places;
    }
    const std::size_t bracket = name.ends_with(']') ? name.rfind('[') : name.npos;
    auto group = groups_.find(name);
    const bool whole = group != groups_.end();
    if (!whole) group = groups_.find(name.substr(0, bracket));
    if (group == groups_.end() || (!whole && bracket == name.npos)) {
        unknown(name.substr(0, bracket), diagnostics);
        return std::nullopt;
    }
    const std::uint32_t count = lamps_->groups()[group->second].lamps;
    std::pair<std::uint32_t, std::uint32_t> numbers(0, count - 1);
    if (!whole) {
        const auto said = numbers_in(name.substr(bracket + 1, name.size() - bracket - 2));
        if (!said || said->second >= count) {
            diagnostics.add(
                error(Fault::option, {}, message("there is no lamp `", printable(name), "`"))
                    .with_help(message("`", printable(group->first), "` has ", count,
                                       count == 1 ? " lamp: " : " lamps: ", printable(group->first),
                                       count == 1 ? "[0]" : "[0] to [",
                                       count == 1 ? "" : message(count - 1, "]"))));
            return std::nullopt;
        }
        numbers = *said;
    }
    if (count == 0) return places;
    for (std::uint32_t number = numbers.first; number <= numbers.second; ++number)
        places.push_back(lamps_->place_of(group->second, number));
    return places;
}

bool LampNames::unknown(std::string_view name, Diagnostics& diagnostics) const {
    std::vector<std::string_view> names;
    std::string all;
    constexpr std::size_t most_said = 20;
    for (const LampGroup& group : lamps_->groups()) {
        names.push_back(group.name);
        if (names.size() <= most_said)
            all += message(all.empty() ? "" : ", ", printable(group.name));
    }
    if (names.size() > most_said) all += ", ...";
    const std::string meant = nearest(std::string(name), names);
    diagnostics.add(
        error(Fault::option, {}, message("there is no lamp `", printable(name), "`"))
            .with_help(
                message(meant.empty() ? "" : message("did you mean `", printable(meant), "`? "),
                        "there are ", all)));
    return false;
}

}  // namespace candelabra
