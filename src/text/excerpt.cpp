// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/excerpt.h"

#include "text/marked_line.h"
#include "text/message.h"
#include "text/palette.h"
#include "text/printable.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

constexpr std::size_t frames_at_each_end = 5;

/// A mark and the line that it is on.
struct Spot {
    Span span;
    int line = 1;
    Mark mark;
};

/// The marked lines of one source.
struct Block {
    SourceId source = no_source;
    Span place;
    std::map<int, std::vector<Mark>> lines;
};

bool can_show(Span span, const SourceStore& sources) {
    return span.known() && span.source < sources.count();
}

/// Moves a span at the end of a text back over trailing blank lines: a missing token is reported
/// after the last word.
Span pull_back(Span span, const SourceStore& sources) {
    const std::string_view text = sources.text(span.source);
    const auto size = static_cast<std::uint32_t>(text.size());
    span.first = std::min(span.first, size);
    span.last = std::clamp(span.last, span.first, size);
    if (span.first < size) return span;
    const std::size_t word = text.find_last_not_of(" \t\r\n");
    const auto end = word == std::string_view::npos ? 0 : static_cast<std::uint32_t>(word + 1);
    return {span.source, end, end};
}

Spot find_spot(Span span, const SourceStore& sources) {
    Spot spot;
    spot.span = pull_back(span, sources);
    const auto [source, first, last] = spot.span;
    spot.line = sources.place(source, first).line;
    const std::string_view line = sources.line(source, spot.line);
    const auto start = static_cast<std::size_t>(line.data() - sources.text(source).data());
    // An offset inside a byte order mark or a line end is not on a character of the line.
    const std::size_t from = first - std::min<std::size_t>(first, start);
    const std::size_t to = last - std::min<std::size_t>(last, start);
    spot.mark.first = std::min(from, line.size());
    spot.mark.last = std::clamp(to, spot.mark.first, line.size());
    return spot;
}

/// Shortens a span of several lines to its first one, and adds the number of its last line to the
/// text.
void mark_further_lines(Spot& spot, const SourceStore& sources) {
    const auto [source, first, last] = spot.span;
    if (last <= first) return;
    const int end = sources.place(source, last - 1).line;
    if (end == spot.line) return;
    const std::string_view line = sources.line(source, spot.line);
    const std::size_t word = line.find_last_not_of(" \t");
    const std::size_t length = word == std::string_view::npos ? 0 : word + 1;
    spot.mark.last = std::max(spot.mark.first, length);
    const std::string text = message("to line ", end);
    spot.mark.text = spot.mark.text.empty() ? text : message(spot.mark.text, " (", text, ")");
}

class Printer {
public:
    Printer(const Diagnostic& diagnostic, const SourceStore& sources, bool coloured)
        : diagnostic_(diagnostic),
          sources_(sources),
          palette_(palette(diagnostic.severity, coloured)) {}

    std::string print() {
        collect_blocks();
        print_head();
        for (std::size_t i = 0; i < blocks_.size(); ++i) print_block(blocks_[i], i == 0);
        print_remarks();
        print_help();
        return std::move(out_);
    }

private:
    void collect(Span span, std::string text, bool primary) {
        if (!can_show(span, sources_)) return;
        Spot spot = find_spot(span, sources_);
        spot.mark.primary = primary;
        spot.mark.text = std::move(text);
        mark_further_lines(spot, sources_);
        auto block = std::find_if(blocks_.begin(), blocks_.end(),
                                  [&](const Block& known) { return known.source == span.source; });
        if (block == blocks_.end()) {
            block = blocks_.insert(blocks_.end(), {span.source, spot.span, {}});
        }
        block->lines[spot.line].push_back(std::move(spot.mark));
        digits_ = std::max(digits_, message(spot.line).size());
    }

    void collect_blocks() {
        collect(diagnostic_.span, diagnostic_.label, true);
        for (const Label& label : diagnostic_.labels) collect(label.span, label.text, false);
    }

    std::string where(Span span) const {
        const Place place = sources_.place(span.source, span.first);
        const std::string name = printable(sources_.name(span.source));
        return message(name, ":", place.line, ":", place.column);
    }

    /// Prints a text of several lines, the further ones indented to align with the first.
    void print_lines(std::string_view text, std::size_t indent, std::string_view ink) {
        while (text.ends_with('\n')) text.remove_suffix(1);
        for (bool more = true; more;) {
            const std::size_t end = text.find('\n');
            out_ += palette_.paint(ink, printable(text.substr(0, end))) + '\n';
            more = end != std::string_view::npos;
            if (!more) break;
            text.remove_prefix(end + 1);
            if (!text.starts_with('\n')) out_.append(indent, ' ');
        }
    }

    void print_head() {
        const Severity severity = diagnostic_.severity;
        // Users need the name of the fault to switch a warning off.
        const std::string title = severity == Severity::error ? "error"
                                  : severity == Severity::warning
                                      ? message("warning[", name(diagnostic_.fault), "]")
                                      : "note";
        out_ += palette_.paint(palette_.primary, title);
        out_ += palette_.paint(palette_.strong, ":") + ' ';
        print_lines(diagnostic_.message, title.size() + 2, palette_.strong);
    }

    void print_gutter(std::string_view number, std::string_view row) {
        std::string gutter(digits_ - number.size(), ' ');
        gutter.append(number).append(" |");
        out_ += palette_.paint(palette_.frame, gutter);
        if (!row.empty()) out_ += ' ';
        out_.append(row) += '\n';
    }

    void print_line(SourceId source, int number, const std::vector<Mark>& marks) {
        const MarkedLine shown = marked_line(sources_.line(source, number), marks, palette_);
        print_gutter(message(number), shown.source);
        for (const std::string& row : shown.below) print_gutter("", row);
    }

    void print_block(const Block& block, bool first) {
        if (!first) print_gutter("", "");
        const std::string arrow = std::string(digits_, ' ') + (first ? "-->" : ":::");
        out_ += palette_.paint(palette_.frame, arrow) + ' ' + where(block.place) + '\n';
        print_gutter("", "");
        int before = 0;
        for (const auto& [number, marks] : block.lines) {
            const bool gap = before > 0 && number > before + 2;
            if (gap) out_ += palette_.paint(palette_.frame, "...") + '\n';
            if (before > 0 && number == before + 2) print_line(block.source, before + 1, {});
            print_line(block.source, number, marks);
            before = number;
        }
    }

    std::string describe(const Frame& frame) const {
        const std::string name = printable(frame.name);
        const bool known = can_show(frame.called_at, sources_);
        const std::string place = known ? where(frame.called_at) : "an unknown place";
        switch (frame.kind) {
            case Frame::macro:
                return message("in macro `", name, "`, called at ", place);
            case Frame::loop:
                return message("in loop `", name, "` at ", place);
            case Frame::include:
                break;
        }
        return message("`", name, "` is included at ", place);
    }

    /// Describes the includes that led to the source of a place, innermost file first.
    std::vector<std::string> include_chain(Span place) const {
        std::vector<std::string> chain;
        while (can_show(place, sources_)) {
            const Span at = sources_.included_at(place.source);
            // A file is included from one that was read before it; any other order would be a
            // cycle.
            if (!at.known() || at.source >= place.source) break;
            chain.push_back(describe({Frame::include, sources_.name(place.source), at}));
            place = at;
        }
        return chain;
    }

    static void append_ends(std::vector<std::string>& lines, std::vector<std::string> part) {
        const std::size_t shown = 2 * frames_at_each_end;
        const std::size_t size = part.size();
        for (std::size_t i = 0; i < size; ++i) {
            const bool hidden =
                size > shown && i >= frames_at_each_end && i < size - frames_at_each_end;
            if (!hidden) lines.push_back(std::move(part[i]));
            if (hidden && i == frames_at_each_end) {
                lines.push_back(message("... ", size - shown, " more"));
            }
        }
    }

    void print_remarks() {
        std::vector<std::string> path;
        for (const Frame& frame : diagnostic_.frames) path.push_back(describe(frame));
        std::vector<std::string> chain;
        for (std::string& step : include_chain(diagnostic_.span)) {
            const bool known = std::find(path.begin(), path.end(), step) != path.end();
            if (!known) chain.push_back(std::move(step));
        }
        std::vector<std::string> remarks = diagnostic_.notes;
        append_ends(remarks, std::move(path));
        append_ends(remarks, std::move(chain));
        if (remarks.empty()) return;
        if (!blocks_.empty()) print_gutter("", "");
        for (const std::string& remark : remarks) {
            out_ += std::string(digits_ + 1, ' ') + palette_.paint(palette_.frame, "=") + ' ';
            print_lines(remark, digits_ + 3, {});
        }
    }

    void print_help() {
        if (diagnostic_.help.empty()) return;
        out_ += palette_.paint(palette_.help, "help:") + ' ';
        print_lines(diagnostic_.help, 6, {});
    }

    const Diagnostic& diagnostic_;
    const SourceStore& sources_;
    const Palette palette_;
    std::vector<Block> blocks_;
    std::size_t digits_ = 1;
    std::string out_;
};

}  // namespace

std::string format(const Diagnostic& diagnostic, const SourceStore& sources, bool coloured) {
    return Printer(diagnostic, sources, coloured).print();
}

}  // namespace candelabra
