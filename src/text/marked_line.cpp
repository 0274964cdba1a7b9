// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/marked_line.h"

#include "text/printable.h"

#include <algorithm>
#include <utility>

namespace candelabra {

namespace {

// Number of bytes around the main mark that are processed: enough for any cut, and few enough for a
// file that is one long line.
constexpr std::size_t reach = 1000;

/// The columns [first, last) that a mark underlines.
struct Stroke {
    std::size_t first;
    std::size_t last;
    const Mark* mark;
};

const Mark& main_mark(const std::vector<Mark>& marks) {
    const auto found =
        std::find_if(marks.begin(), marks.end(), [](const Mark& mark) { return mark.primary; });
    return found == marks.end() ? marks.front() : *found;
}

/// Advances an offset to the beginning of a character.
std::size_t character_start(std::string_view line, std::size_t offset) {
    for (int skipped = 0; skipped < 3 && offset < line.size(); ++skipped, ++offset) {
        if ((static_cast<unsigned char>(line[offset]) & 0xC0) != 0x80) break;
    }
    return std::min(offset, line.size());
}

/// The processed part of a line, as one printable string per column.
class Columns {
public:
    Columns(std::string_view line, std::size_t centre) {
        from_ = centre > reach ? character_start(line, centre - reach) : 0;
        const std::size_t to = character_start(line, std::min(centre, line.size()) + reach);
        const std::string_view part = line.substr(std::min(from_, to), to - std::min(from_, to));
        for (std::size_t at = 0; at < part.size();) {
            const Character character = character_at(part, at);
            column_of_byte_.insert(column_of_byte_.end(), character.length, shown_.size());
            if (character.code == '\t') {
                shown_.resize((shown_.size() / tab_width + 1) * tab_width, " ");
            } else {
                shown_.push_back(harmless_character(part, at, character));
            }
            at += character.length;
        }
        column_of_byte_.push_back(shown_.size());
    }

    std::size_t column(std::size_t byte) const {
        if (byte < from_) return 0;
        return column_of_byte_[std::min(byte - from_, column_of_byte_.size() - 1)];
    }

    Stroke stroke(const Mark& mark) const {
        const std::size_t first = column(mark.first);
        return {first, std::max(column(mark.last), first + 1), &mark};
    }

    const std::vector<std::string>& shown() const { return shown_; }

private:
    std::size_t from_ = 0;
    std::vector<std::string> shown_;
    std::vector<std::size_t> column_of_byte_;
};

/// Returns the first column to show of a line that is too long.
std::size_t window_start(const std::vector<Stroke>& strokes, const Stroke& main,
                         std::size_t columns) {
    constexpr std::size_t room = max_columns - 20;
    std::size_t first = main.first;
    std::size_t last = main.last;
    for (const Stroke& stroke : strokes) {
        first = std::min(first, stroke.first);
        last = std::max(last, stroke.last);
    }
    if (last - first > room) {
        first = main.first;
        last = std::min(main.last, first + room);
    }
    const std::size_t margin = (max_columns - (last - first)) / 2;
    return std::min(first - std::min(first, margin), columns - max_columns);
}

/// Cuts the row to a window and moves the strokes with it; strokes outside are clamped to its
/// edges.
std::vector<std::string> cut(const std::vector<std::string>& shown, std::vector<Stroke>& strokes,
                             const Stroke& main) {
    if (shown.size() <= max_columns) return shown;
    const std::size_t start = window_start(strokes, main, shown.size());
    const std::size_t end = start + max_columns;
    const auto at = [&](std::size_t column) {
        return shown.begin() + static_cast<std::ptrdiff_t>(column);
    };
    std::vector<std::string> row(at(start), at(end));
    if (start > 0) row.front() = "…";
    if (end < shown.size()) row.back() = "…";
    // If the end of the line is shown, the column after it can be marked, too.
    const std::size_t rightmost = end < shown.size() ? max_columns - 1 : max_columns;
    for (Stroke& stroke : strokes) {
        stroke.first = std::clamp(stroke.first, start, start + rightmost) - start;
        stroke.last = std::clamp(stroke.last, start, start + rightmost + 1) - start;
        stroke.last = std::max(stroke.last, stroke.first + 1);
    }
    return row;
}

std::string trimmed(std::string row) {
    row.erase(row.find_last_not_of(' ') + 1);
    return row;
}

std::string_view colour(const Palette& palette, const Mark& mark) {
    return mark.primary ? palette.primary : palette.frame;
}

/// Returns the row of carets and dashes, the main mark on top.
std::string underline(const std::vector<Stroke>& strokes, const Palette& palette) {
    std::size_t width = 0;
    for (const Stroke& stroke : strokes) width = std::max(width, stroke.last);
    std::string row(width, ' ');
    for (const bool primary : {false, true}) {
        for (const Stroke& stroke : strokes) {
            if (stroke.mark->primary != primary) continue;
            row.replace(stroke.first, stroke.last - stroke.first, stroke.last - stroke.first,
                        primary ? '^' : '-');
        }
    }
    std::string painted;
    for (std::size_t at = 0; at < row.size();) {
        const std::size_t next = std::min(row.find_first_not_of(row[at], at), row.size());
        const std::string run = row.substr(at, next - at);
        const std::string_view ink = run[0] == '^' ? palette.primary : palette.frame;
        painted += run[0] == ' ' ? run : palette.paint(ink, run);
        at = next;
    }
    return painted;
}

/// Returns the stroke whose text is placed beside the marks: the one that ends last.
const Stroke* beside(const std::vector<Stroke>& strokes) {
    const Stroke* last = &strokes.front();
    for (const Stroke& stroke : strokes) {
        const bool further = stroke.last > last->last;
        const bool same = stroke.last == last->last;
        if (further || (same && stroke.mark->primary && !last->mark->primary)) last = &stroke;
    }
    return last;
}

/// Returns a row with a bar below each stroke from index `from` on, to be followed by a text.
std::string bars(const std::vector<Stroke>& hanging, std::size_t from, const Palette& palette) {
    std::string row;
    std::size_t width = 0;
    for (std::size_t i = hanging.size(); i-- > from;) {
        if (i + 1 < hanging.size() && hanging[i].first == hanging[i + 1].first) continue;
        row.append(hanging[i].first - width, ' ');
        row += palette.paint(colour(palette, *hanging[i].mark), "|");
        width = hanging[i].first + 1;
    }
    return row;
}

/// Appends the texts that do not fit beside the marks, each below its own mark, from right to left.
void hang(std::vector<Stroke> hanging, const Palette& palette, std::vector<std::string>& rows) {
    if (hanging.empty()) return;
    std::stable_sort(hanging.begin(), hanging.end(),
                     [](const Stroke& a, const Stroke& b) { return a.first > b.first; });
    rows.push_back(bars(hanging, 0, palette));
    for (std::size_t i = 0; i < hanging.size(); ++i) {
        std::size_t left = i + 1;
        while (left < hanging.size() && hanging[left].first == hanging[i].first) ++left;
        std::string row = bars(hanging, left, palette);
        const std::size_t width = left < hanging.size() ? hanging[left].first + 1 : 0;
        row.append(hanging[i].first - width, ' ');
        const Mark& mark = *hanging[i].mark;
        rows.push_back(row + palette.paint(colour(palette, mark), printable(mark.text)));
    }
}

}  // namespace

MarkedLine marked_line(std::string_view line, const std::vector<Mark>& marks,
                       const Palette& palette) {
    MarkedLine result;
    if (marks.empty()) {
        const Columns columns(line, 0);
        std::vector<Stroke> none;
        for (const auto& shown : cut(columns.shown(), none, {0, 1, nullptr})) {
            result.source += shown;
        }
        result.source = trimmed(result.source);
        return result;
    }
    const Mark& main = main_mark(marks);
    const Columns columns(line, main.first);
    std::vector<Stroke> strokes;
    for (const Mark& mark : marks) strokes.push_back(columns.stroke(mark));
    for (const auto& shown : cut(columns.shown(), strokes, columns.stroke(main))) {
        result.source += shown;
    }
    result.source = trimmed(result.source);

    const Stroke* aside = beside(strokes);
    std::string first_row = underline(strokes, palette);
    if (!aside->mark->text.empty()) {
        const auto ink = colour(palette, *aside->mark);
        first_row += ' ' + palette.paint(ink, printable(aside->mark->text));
    }
    result.below.push_back(first_row);
    std::vector<Stroke> hanging;
    for (const Stroke& stroke : strokes) {
        if (&stroke != aside && !stroke.mark->text.empty()) hanging.push_back(stroke);
    }
    hang(std::move(hanging), palette, result.below);
    return result;
}

}  // namespace candelabra
