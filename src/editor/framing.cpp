// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/framing.h"

#include "text/ascii.h"
#include "text/message.h"
#include "text/trimmed.h"

#include <algorithm>
#include <charconv>
#include <system_error>
#include <utility>

namespace candelabra {

namespace {

constexpr std::string_view line_end = "\r\n", blank_line = "\r\n\r\n";
constexpr std::string_view length_name = "Content-Length";

}  // namespace

void Framing::add(std::string_view bytes) {
    if (!lost_.empty()) return;
    const auto passed = static_cast<std::size_t>(std::min<std::uint64_t>(skip_, bytes.size()));
    skip_ -= passed;
    waiting_ += bytes.substr(passed);
}

std::optional<Framing::Message> Framing::take() {
    if (!lost_.empty() || skip_ > 0) return std::nullopt;
    if (std::exchange(skipping_, false)) return Message{{}, true};
    const std::size_t head = waiting_.find(blank_line);
    if (std::min(head, waiting_.size()) > longest_head) {
        lost_ = message("the head of a message has more than ", longest_head, " bytes");
        return std::nullopt;
    }
    if (head == waiting_.npos) return std::nullopt;
    const auto wanted = length(std::string_view(waiting_).substr(0, head));
    if (!wanted) return std::nullopt;
    const std::size_t first = head + blank_line.size(), there = waiting_.size() - first;
    if (*wanted > longest_message) {
        skip_ = *wanted;
        skipping_ = true;
        const std::string rest = waiting_.substr(first);
        waiting_.clear();
        add(rest);
        return take();
    }
    if (there < *wanted) return std::nullopt;
    Message message{waiting_.substr(first, static_cast<std::size_t>(*wanted))};
    waiting_.erase(0, first + message.text.size());
    return message;
}

std::optional<std::uint64_t> Framing::length(std::string_view head) {
    std::optional<std::string_view> found;
    const auto lose = [&](std::string why) {
        lost_ = std::move(why);
        return std::nullopt;
    };
    while (!head.empty()) {
        const std::string_view line = head.substr(0, head.find(line_end));
        head.remove_prefix(std::min(head.size(), line.size() + line_end.size()));
        const std::size_t colon = line.find(':');
        if (colon == line.npos || colon == 0)
            return lose("a line in the head of a message is no header");
        if (!same_letters(line.substr(0, colon), length_name)) continue;
        if (found) return lose("a message has two lengths");
        found = trimmed(line.substr(colon + 1), " \t");
    }
    if (!found) return lose("a message has no Content-Length");
    std::uint64_t value = 0;
    const auto [end, problem] =
        std::from_chars(found->data(), found->data() + found->size(), value);
    if (problem == std::errc::invalid_argument || end != found->data() + found->size())
        return lose("the Content-Length of a message is no number");
    if (problem != std::errc() || value > longest_skip)
        return lose(message("a message has more than ", longest_skip, " bytes"));
    return value;
}

}  // namespace candelabra
