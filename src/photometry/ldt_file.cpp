// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/ldt_file.h"

#include "photometry/photometric_text.h"
#include "photometry/web_table.h"
#include "text/message.h"
#include "text/printable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace candelabra {

namespace {

constexpr double metres_per_millimetre = 1e-3;

/// The lines of a file one after the other, with the first error.
class LdtLines {
public:
    explicit LdtLines(std::vector<std::string> lines) : lines_(std::move(lines)) {}

    const std::string& problem() const { return problem_; }
    bool failed() const { return !problem_.empty(); }
    void fail(std::string_view text) {
        if (!failed()) problem_ = message("line ", std::max<std::size_t>(line_, 1), ": ", text);
    }

    /// The next line without blanks around it; empty after the end, which is an error.
    std::string_view text(std::string_view what) {
        if (line_ == lines_.size()) fail(message("the file ends before ", what));
        if (failed()) return {};
        return trimmed(lines_[line_++]);
    }

    /// A number, perhaps with a decimal comma; an empty line is 0.
    double number(std::string_view what) {
        std::string digits(text(what));
        if (digits.empty()) return 0;
        std::ranges::replace(digits, ',', '.');
        const std::optional<double> value = number_of(digits);
        if (!value)
            fail(message("`", printable(digits), "` is no number, and ", what, " is wanted"));
        return value.value_or(0);
    }

    int whole(std::string_view what, double least, double most) {
        const double value = number(what);
        if (!failed() && (value != std::trunc(value) || value < least || value > most))
            fail(message(what, " is ", value, " and must be a whole number from ", least, " to ",
                         most));
        return failed() ? 0 : static_cast<int>(value);
    }

    std::vector<double> list(std::string_view what, int count) {
        std::vector<double> values;
        for (int i = 0; i < count && !failed(); ++i)
            values.push_back(number(message(what, ' ', i + 1, " of ", count)));
        return values;
    }

private:
    std::vector<std::string> lines_;
    std::size_t line_ = 0;
    std::string problem_;
};

/// What Isym means.
struct Symmetry {
    std::string_view name;
    int planes;  ///< that are stored of Mc on the full circle
    int first;   ///< the first of them
};

/// Precondition: Mc fits the symmetry.
Symmetry symmetry_of(int number, int around) {
    switch (number) {
        case 1:
            return {"Isym 1", 1, 0};
        case 2:
            return {"Isym 2", around / 2 + 1, 0};
        case 3:
            return {"Isym 3", around / 2 + 1, 3 * around / 4};
        case 4:
            return {"Isym 4", around / 4 + 1, 0};
        default:
            return {"Isym 0", around, 0};
    }
}

/// The lines before the lamp sets.
struct LdtHead {
    int symmetry = 0, around = 0, rows = 0, sets = 0;
    double conversion = 1;
};

void read_opening(LdtLines& lines, PhotometricFile& file) {
    lines.list("the size of the luminaire", 3);
    const double length = lines.number("the luminous length"),
                 width = lines.number("the luminous width");
    double height = 0;
    for (const double each : lines.list("the luminous height", 4)) height = std::max(height, each);
    const double unit = metres_per_millimetre;
    // Round openings have a negative diameter in LM-63, whose names of shapes these are.
    file.opening = {"point", unit * width, unit * length, unit * height};
    if (width == 0 && length > 0) {
        file.opening.width = file.opening.length = -unit * length;
        file.opening.shape = height > 0 ? "vertical cylinder" : "disc";
    } else if (width > 0) {
        file.opening.shape = height > 0 ? "box" : "rectangle";
    }
}

LdtHead read_head(LdtLines& lines, PhotometricFile& file) {
    LdtHead head;
    const auto label = [&](const char* keyword, std::string_view what) {
        file.labels.emplace_back(keyword, lines.text(what));
    };
    label("MANUFAC", "the maker");
    lines.number("the kind of luminaire");
    head.symmetry = lines.whole("the number of the symmetry (Isym)", 0, 4);
    head.around = lines.whole("the number of C planes (Mc)", 1, max_photometric_angles);
    lines.number("the step of the C planes");
    head.rows = lines.whole("the number of angles (Ng)", 2, max_photometric_angles);
    lines.number("the step of the angles");
    if (static_cast<double>(head.rows) * head.around > max_photometric_entries)
        lines.fail("the table has more than a million entries");
    label("TEST", "the report");
    label("LUMINAIRE", "the name of the luminaire");
    label("LUMCAT", "the number of the luminaire");
    label("FILENAME", "the name of the file");
    label("ISSUEDATE", "the date");
    read_opening(lines, file);
    lines.number("the flux downwards");
    file.efficiency = lines.number("the efficiency (LORL)");
    const double conversion = lines.number("the conversion factor");
    head.conversion = conversion > 0 ? conversion : 1;
    lines.number("the tilt of the measurement");
    constexpr int max_sets = 1000;
    head.sets = lines.whole("the number of lamp sets", 1, max_sets);
    if (head.symmetry > 1 && head.around % (head.symmetry == 2 ? 2 : 4) != 0)
        lines.fail(message(head.around, " C planes do not fit Isym ", head.symmetry));
    return head;
}

void read_sets(LdtLines& lines, int count, PhotometricFile& file) {
    file.sets.resize(static_cast<std::size_t>(count));
    for (LampSet& each : file.sets) each.count = lines.number("the number of lamps");
    for (LampSet& each : file.sets) each.type = lines.text("the type of the lamps");
    for (LampSet& each : file.sets) each.flux = lines.number("the flux of the lamps");
    for (LampSet& each : file.sets) each.colour_temperature = lines.text("the colour temperature");
    for (LampSet& each : file.sets) each.colour_rendering = lines.text("the colour rendering");
    for (LampSet& each : file.sets) each.watts = lines.number("the watts");
}

bool rise(const std::vector<double>& angles) {
    return std::ranges::adjacent_find(angles, std::ranges::greater_equal()) == angles.end();
}

/// Puts the stored planes in the order of their angles. `all` has the angles of the full circle.
WebTable table_of(const LdtHead& head, const Symmetry& stored, const std::vector<double>& all,
                  std::vector<double> rows, std::vector<double> values) {
    WebTable table{WebType::c, std::move(rows), {}, std::move(values)};
    constexpr double full_turn = 360;
    for (int i = 0; i < stored.planes; ++i) {
        const int place = stored.first + i;
        const double angle = all[static_cast<std::size_t>(place % head.around)];
        table.horizontal.push_back(angle + (place >= head.around ? full_turn : 0));
    }
    return table;
}

/// Completes the table by Isym, and not by the range of its planes.
std::string complete(const LdtHead& head, WebTable table, PhotometricFile& file) {
    std::string range;  // LM-63's name of the symmetry, which must be that of Isym
    if (!rise(table.horizontal)) return "the C angles do not increase";
    if (head.symmetry == 0) {
        if (table.horizontal.back() > table.horizontal.front() + 360.01)
            return "the C angles go around more than once";
        file.web = closed_web(std::move(table), file.notes);
        return {};
    }
    std::string problem = complete_table(std::move(table), file.web, range, file.notes);
    static constexpr auto meant = std::to_array<std::string_view>(
        {"", "axial", "bilateral 0-180", "bilateral 90-270", "quadrant"});
    if (problem.empty() && range != meant[static_cast<std::size_t>(head.symmetry)])
        problem = message("the C angles do not fit Isym ", head.symmetry);
    return problem;
}

}  // namespace

std::string read_ldt(std::string_view bytes, const PhotometricChoice& choice,
                     PhotometricFile& file) {
    PhotometricFile made;
    bool latin = false;
    LdtLines lines(lines_of(bytes, latin));
    made.format = "EULUMDAT";
    const LdtHead head = read_head(lines, made);
    if (lines.failed()) return lines.problem();
    read_sets(lines, head.sets, made);
    constexpr int ratios = 10;
    lines.list("the direct ratio", ratios);
    const Symmetry stored = symmetry_of(head.symmetry, head.around);
    made.symmetry = stored.name;
    made.symmetry_number = head.symmetry;
    const std::vector<double> all = lines.list("C angle", head.around),
                              rows = lines.list("angle", head.rows);
    if (!lines.failed() && (!rise(rows) || rows.front() < 0 || rows.back() > 180))
        lines.fail("the angles must increase from 0 to 180 degrees");
    std::vector<double> values = lines.list("intensity", stored.planes * head.rows);
    if (lines.failed()) return lines.problem();
    if (choice.set >= made.sets.size())
        return message("it has ", made.sets.size(), " sets of lamps, and no number ",
                       choice.set + 1);
    made.set = choice.set;
    const LampSet& lamps = made.sets[made.set];
    made.absolute = lamps.count < 0;
    made.watts = lamps.watts;
    made.lumens_per_lamp = made.absolute ? -1 : lamps.flux / std::max(lamps.count, 1.0);
    constexpr double per_kilolumen = 1e-3;
    bool below = false;
    for (double& each : values) {
        below |= each < 0;
        each = std::max(each * lamps.flux * per_kilolumen * head.conversion, 0.0);
        if (!(each <= max_candela))
            return message("an intensity is more than ", max_candela, " cd");
    }
    if (below) made.notes.push_back("negative intensities are taken to be 0");
    if (made.sets.size() > 1)
        made.notes.push_back(message("it has ", made.sets.size(),
                                     " sets of lamps, of which number ", made.set + 1,
                                     " is taken"));
    std::string problem =
        complete(head, table_of(head, stored, all, rows, std::move(values)), made);
    if (problem.empty()) file = std::move(made);
    return problem;
}

}  // namespace candelabra
