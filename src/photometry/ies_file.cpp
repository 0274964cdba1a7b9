// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/ies_file.h"

#include "photometry/photometric_text.h"
#include "photometry/web_table.h"
#include "text/ascii.h"
#include "text/message.h"
#include "text/printable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace candelabra {

namespace {

using TextLines = std::vector<std::string>;

constexpr int first_year = 1986, without_second_factor = 1995;
constexpr double metres_per_foot = 0.3048;
/// Labels and notes of a file beyond these numbers are not kept.
constexpr std::size_t max_labels = 200, max_notes = 20, max_label = 1000;

std::string without_blanks(std::string_view text) {
    std::string result;
    for (const char c : text)
        if (c != ' ' && c != '\t') result += c;
    return result;
}

/// Returns the word behind `TILT=`; nothing for another line.
std::optional<std::string> tilt_of(std::string_view line) {
    const std::string text = without_blanks(line);
    constexpr std::string_view start = "tilt=";
    if (!same_letters(std::string_view(text).substr(0, start.size()), start)) return std::nullopt;
    return text.substr(start.size());
}

/// Returns the year of the standard that the first line names; nothing if it names none.
std::optional<int> year_of(std::string_view line) {
    const std::string text = lower_case(without_blanks(line));
    if (text.starts_with("iesna91")) return 1991;
    const std::size_t name = text.find("lm-63-");
    if (!text.starts_with("ies") || name == text.npos) return std::nullopt;
    const auto year = number_of(std::string_view(text).substr(name + 6, 4));
    return year ? std::optional(static_cast<int>(*year)) : std::nullopt;
}

/// The lines before the numbers.
class IesHead {
public:
    IesHead(const TextLines& lines, PhotometricFile& file) : lines_(lines), file_(file) {}

    /// Returns an error, or an empty string. Afterwards line() is that behind the line of TILT.
    std::string read() {
        while (line_ < lines_.size() && trimmed(lines_[line_]).empty()) ++line_;
        file_.version = first_year;
        if (line_ < lines_.size()) {
            if (const auto year = year_of(lines_[line_])) {
                take_year(*year);
                ++line_;
            }
        }
        for (; line_ < lines_.size(); ++line_) {
            if (const auto tilt = tilt_of(lines_[line_])) {
                tilt_ = *tilt;
                ++line_;
                return {};
            }
            const std::string_view text = trimmed(lines_[line_]);
            if (!text.empty() && !take_label(text))
                return message("line ", line_ + 1,
                               ": BLOCK: a file with several luminaires is not read; put each "
                               "into a file of its own");
        }
        return "it has no line `TILT=`";
    }

    std::size_t line() const { return line_; }
    const std::string& tilt() const { return tilt_; }

private:
    void take_year(int year) {
        static constexpr auto years = std::to_array({first_year, 1991, 1995, 2002, 2019});
        file_.version = year;
        if (std::ranges::find(years, year) == years.end())
            note(message("the standard of ", year, " is not known: read as the one before it"));
        if (without_blanks(lines_[line_]) != trimmed(lines_[line_]))
            note("the line of the version has blanks in it");
    }

    /// Returns false for the beginning of a block.
    bool take_label(std::string_view text) {
        const std::size_t end = text.find(']');
        if (text.front() != '[' || end == text.npos) {
            if (file_.version != first_year)
                note(message("line ", line_ + 1, " has no keyword in brackets: passed over"));
            else if (file_.labels.size() < max_labels)
                file_.labels.emplace_back("OTHER", text);
            return true;
        }
        std::string keyword;
        for (const char c : trimmed(text.substr(1, end - 1)))
            keyword += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        if (keyword == "BLOCK") return false;
        const std::string_view value = trimmed(text.substr(end + 1)).substr(0, max_label);
        if (keyword == "MORE" && !file_.labels.empty()) {
            std::string& before = file_.labels.back().second;
            if (before.size() < max_label) before += message(' ', value);
        } else if (file_.labels.size() < max_labels) {
            file_.labels.emplace_back(std::move(keyword), value);
        }
        return true;
    }

    void note(std::string text) {
        if (file_.notes.size() < max_notes) file_.notes.push_back(std::move(text));
    }

    const TextLines& lines_;
    PhotometricFile& file_;
    std::size_t line_ = 0;
    std::string tilt_;
};

/// The numbers behind the line of TILT, with the first error.
class Numbers {
public:
    Numbers(const TextLines& lines, std::size_t line) : stream_(lines, line) {}

    const std::string& problem() const { return problem_; }
    bool failed() const { return !problem_.empty(); }
    void fail(std::string_view text) {
        if (!failed()) problem_ = message("line ", stream_.line(), ": ", text);
    }

    /// `what` names the number in an error. 0 after an error.
    double take(std::string_view what) {
        if (failed()) return 0;
        if (const auto number = stream_.next()) return *number;
        if (stream_.stray().empty())
            fail(message("the file ends before ", what));
        else
            fail(message("`", printable(stream_.stray()), "` is no number, and ", what,
                         " is wanted"));
        return 0;
    }

    /// A whole number, perhaps written as 1.0.
    int whole(std::string_view what, double least, double most) {
        const double number = take(what);
        if (!failed() && (number != std::trunc(number) || number < least || number > most))
            fail(message(what, " is ", number, " and must be a whole number from ", least, " to ",
                         most));
        return failed() ? 0 : static_cast<int>(number);
    }

    std::vector<double> list(std::string_view what, int count) {
        std::vector<double> result;
        for (int i = 0; i < count && !failed(); ++i)
            result.push_back(take(message(what, ' ', i + 1, " of ", count)));
        return result;
    }

    std::vector<double> rising(std::string_view what, int count, double least, double most) {
        std::vector<double> result = list(what, count);
        for (std::size_t i = 0; i < result.size() && !failed(); ++i) {
            if (!(result[i] >= least && result[i] <= most))
                fail(message(what, ' ', result[i], " is not between ", least, " and ", most));
            else if (i > 0 && result[i] <= result[i - 1])
                fail(message(what, ' ', result[i], " follows ", result[i - 1],
                             ": the angles must increase"));
        }
        return result;
    }

    /// Numbers that are left, and whether one of them is not 0; a text that is none ends them.
    std::pair<std::size_t, bool> rest() {
        std::size_t count = 0;
        bool other = false;
        while (const auto number = stream_.next()) {
            ++count;
            other |= *number != 0;
        }
        return {count, other || !stream_.stray().empty()};
    }

private:
    NumberStream stream_;
    std::string problem_;
};

void read_tilt(const std::string& tilt, Numbers& numbers, PhotometricFile& file) {
    if (same_letters(tilt, "none")) return;
    if (!same_letters(tilt, "include")) {
        file.notes.push_back(message("the factors of tilting are in another file, `",
                                     printable(tilt), "`, and are not read"));
        return;
    }
    constexpr int most = static_cast<int>(max_photometric_angles);
    LampTilt made;
    made.geometry = numbers.whole("the lamp's geometry", 1, 3);
    const int count = numbers.whole("the number of tilts", 1, most);
    made.angles = numbers.rising("tilt", count, 0, 180);
    made.factors = numbers.list("factor of tilt", count);
    if (std::ranges::any_of(made.factors, [](double factor) { return factor < 0; }))
        file.notes.emplace_back("a factor of tilt below 0 counts as 0");
    for (double& factor : made.factors) factor = std::fmax(factor, 0);
    file.tilt = std::move(made);
}

/// Reads the table and all numbers before it. Returns an error, or an empty string.
std::string read_numbers(Numbers& numbers, PhotometricFile& file, WebTable& table) {
    constexpr double any = 1e9;
    LampSet lamps;
    lamps.count = numbers.whole("the number of lamps", -any, any);
    const double lumens = numbers.take("the lumens of each lamp");
    double factor = numbers.take("the multiplier of candela");
    const int rows = numbers.whole("the number of vertical angles", 2, max_photometric_angles),
              planes = numbers.whole("the number of horizontal angles", 1, max_photometric_angles);
    if (static_cast<double>(rows) * planes > max_photometric_entries)
        numbers.fail("the table has more than a million entries");
    table.type = static_cast<WebType>(numbers.whole("the type", 1, 3) - 1);
    const double unit = numbers.whole("the unit", 1, 2) == 1 ? metres_per_foot : 1;
    const double width = numbers.take("the width"), length = numbers.take("the length"),
                 height = numbers.take("the height");
    const double ballast = numbers.take("the ballast factor"),
                 second = numbers.take("the second factor");
    file.watts = lamps.watts = numbers.take("the input watts");
    const bool around = table.type == WebType::c;
    constexpr double turns = 720;
    table.vertical = numbers.rising("vertical angle", rows, around ? 0 : -90, around ? 180 : 90);
    table.horizontal =
        numbers.rising("horizontal angle", planes, around ? -turns : -90, around ? turns : 90);
    table.candela = numbers.list("candela value", rows * planes);
    if (numbers.failed()) return numbers.problem();
    // Later years reserve the second factor, or keep the type of the file in it.
    factor *= ballast * (file.version < without_second_factor ? second : 1);
    file.absolute = lumens < 0;
    lamps.flux = file.absolute ? 0 : std::abs(lamps.count) * lumens;
    file.sets = {lamps};
    file.lumens_per_lamp = lumens;
    file.opening = ies_opening(file.version, unit * width, unit * length, unit * height);
    bool below = false;
    for (double& each : table.candela) {
        below |= each < 0;
        each = std::max(each * factor, 0.0);
        if (!(each <= max_candela))
            return message("an intensity is more than ", max_candela, " cd");
    }
    if (below) file.notes.push_back("negative intensities are taken to be 0");
    return {};
}

/// Some files have a few numbers too many; a table that is cut wrongly has more of them.
std::string check_rest(Numbers& numbers, PhotometricFile& file) {
    constexpr std::size_t harmless = 2;
    const auto [count, other] = numbers.rest();
    if (count > harmless && other)
        return message("there are ", count, " numbers too many behind the table");
    if (count > 0)
        file.notes.push_back(message(count, count == 1 ? " number too many" : " numbers too many"));
    else if (other)
        file.notes.push_back("there is other text behind the table");
    return {};
}

}  // namespace

bool is_ies(std::string_view bytes) {
    bool latin = false;
    constexpr std::size_t enough = 1 << 16;
    const TextLines lines = lines_of(bytes.substr(0, enough), latin);
    const auto first =
        std::ranges::find_if(lines, [](const std::string& line) { return !trimmed(line).empty(); });
    if (first != lines.end() && year_of(*first)) return true;
    return std::ranges::any_of(lines,
                               [](const std::string& line) { return tilt_of(line).has_value(); });
}

LuminousOpening ies_opening(int year, double width, double length, double height) {
    LuminousOpening opening{"point", width, length, height};
    const bool round_width = width < 0, round_length = length < 0, round_height = height < 0;
    const bool old = year < 1995, modern = year >= 2002;
    const auto equal = [](double a, double b) {
        return std::abs(std::abs(a) - std::abs(b)) < 1e-6;
    };
    const bool circular =
        (round_width && length == 0) || (round_width && round_length && equal(width, length));
    if (height == 0) {
        if (round_width || round_length)
            opening.shape = circular ? "disc" : "ellipse";
        else if (width > 0 || length > 0)
            opening.shape = "rectangle";
    } else if (!round_height) {
        if (!round_width && !round_length)
            opening.shape = "box";
        else if (circular)
            opening.shape = "vertical cylinder";
        else
            opening.shape = old ? "ellipsoid" : "vertical elliptic cylinder";
    } else if (round_width && round_length) {
        opening.shape = equal(width, length) && equal(width, height) ? "sphere" : "ellipsoid";
    } else if (round_width && length == 0) {
        opening.shape = modern ? "vertical disc" : "sphere";
    } else if (width > 0 && length <= 0) {
        opening.shape = "horizontal cylinder across";
    } else if (length > 0 && (width == 0 || modern)) {
        opening.shape = "horizontal cylinder along";
    } else if (round_width || round_length) {
        opening.shape = "ellipsoid";
    }
    return opening;
}

std::string read_ies(std::string_view bytes, PhotometricFile& file) {
    PhotometricFile made;
    bool latin = false;
    const TextLines lines = lines_of(bytes, latin);
    if (latin) made.notes.push_back("its text is Latin-1");
    IesHead head(lines, made);
    if (std::string problem = head.read(); !problem.empty()) return problem;
    made.format = message("IES LM-63-", made.version);
    Numbers numbers(lines, head.line());
    read_tilt(head.tilt(), numbers, made);
    WebTable table;
    std::string problem = read_numbers(numbers, made, table);
    if (problem.empty()) problem = check_rest(numbers, made);
    if (problem.empty())
        problem = complete_table(std::move(table), made.web, made.symmetry, made.notes);
    if (problem.empty()) file = std::move(made);
    return problem;
}

}  // namespace candelabra
