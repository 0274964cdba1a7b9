// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/source.h"

#include "text/utf8.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace candelabra {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

std::vector<std::uint32_t> find_line_starts(std::string_view text) {
    std::vector<std::uint32_t> starts;
    starts.push_back(text.starts_with(byte_order_mark) ? 3 : 0);
    // Searching for either of two characters takes ten times as long, which matters in files of 100
    // MB.
    const bool returns = text.find('\r') != std::string_view::npos;
    const auto line_end = [&](std::size_t from) {
        return returns ? text.find_first_of("\r\n", from) : text.find('\n', from);
    };
    for (std::size_t end = line_end(0); end != std::string_view::npos;) {
        const std::size_t next = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
        starts.push_back(static_cast<std::uint32_t>(next));
        end = line_end(next);
    }
    return starts;
}

}  // namespace

SourceId SourceStore::add(std::string name, std::string text, Span included_at) {
    assert(text.size() < std::numeric_limits<std::uint32_t>::max());
    auto starts = find_line_starts(text);
    sources_.push_back({std::move(name), std::move(text), included_at, std::move(starts)});
    return static_cast<SourceId>(sources_.size() - 1);
}

const SourceStore::Source& SourceStore::source(SourceId id) const {
    static const Source nothing{"", "", {}, {0}};
    return id < sources_.size() ? sources_[id] : nothing;
}

std::string_view SourceStore::text(SourceId id) const { return source(id).text; }

const std::string& SourceStore::name(SourceId id) const { return source(id).name; }

Span SourceStore::included_at(SourceId id) const { return source(id).included_at; }

Place SourceStore::place(SourceId id, std::uint32_t offset) const {
    const Source& in = source(id);
    const auto& starts = in.line_starts;
    const auto size = static_cast<std::uint32_t>(in.text.size());
    offset = std::clamp(offset, starts.front(), std::max(size, starts.front()));
    const auto after = std::upper_bound(starts.begin(), starts.end(), offset);
    const std::uint32_t start = *(after - 1);
    const auto before = std::string_view(in.text).substr(start, offset - start);
    return {static_cast<int>(after - starts.begin()),
            static_cast<int>(character_count(before)) + 1};
}

std::string_view SourceStore::line(SourceId id, int line) const {
    const Source& in = source(id);
    if (line < 1 || line > line_count(id)) return {};
    const auto index = static_cast<std::size_t>(line - 1);
    const std::uint32_t start = in.line_starts[index];
    std::string_view text = std::string_view(in.text).substr(start);
    return text.substr(0, text.find_first_of("\r\n"));
}

int SourceStore::line_count(SourceId id) const {
    return static_cast<int>(source(id).line_starts.size());
}

}  // namespace candelabra
