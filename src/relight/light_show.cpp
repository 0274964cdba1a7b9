// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/light_show.h"

#include "interpret/csv.h"
#include "output/light_weights.h"
#include "text/ascii.h"
#include "text/decimal.h"
#include "text/message.h"
#include "text/opened_file.h"
#include "text/printable.h"
#include "text/trimmed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace candelabra {

namespace {

constexpr std::size_t most_table_bytes = std::size_t{1} << 30;
constexpr std::size_t most_cells = 20'000'000;
constexpr std::string_view value_rule =
    "a value is a number from 0 on, a colour, or both: 0.5, #ff8800, or 0.5,#ff8800";

/// A cell without the blanks around it.
std::string_view bare(std::string_view cell) { return trimmed(cell, " \t\r"); }

/// One column of a table for each lamp.
class TableFrames final : public ShowFrames {
public:
    using Factor = std::array<float, 3>;

    std::size_t count() const override { return rows; }

    void set(std::size_t frame, std::vector<Rgb>& factors) const override {
        const Factor* cell = cells.data() + frame * columns.size();
        for (const std::vector<std::uint32_t>& lamps : columns) {
            const Factor& factor = *cell++;
            if (!(factor[0] >= 0)) continue;
            for (const std::uint32_t lamp : lamps)
                factors[lamp] = Rgb(factor[0], factor[1], factor[2]);
        }
    }

    std::vector<std::vector<std::uint32_t>> columns;  ///< lamps of each
    std::vector<Factor> cells;                        ///< row by row; below 0: empty
    std::size_t rows = 0;
};

/// Fades from one look to the next, as on a lighting console: lamps that a cue does not name go on
/// with what they do.
class CueFrames final : public ShowFrames {
public:
    struct Cue {
        double time = 0, fade = 0;
        std::vector<std::pair<std::uint32_t, Rgb>> looks;
    };

    std::size_t count() const override {
        double end = 0;
        for (const Cue& cue : cues) end = std::max(end, cue.time + cue.fade);
        constexpr double rounding = 1e-9;
        return static_cast<std::size_t>(std::floor(end * rate + rounding)) + 1;
    }

    void set(std::size_t frame, std::vector<Rgb>& factors) const override {
        struct Fade {
            Rgb from, to;
            double begin = 0, length = 0;

            Rgb at(double time) const {
                const double share = length > 0 ? (time - begin) / length : 1;
                return share >= 1 ? to : from + share * (to - from);
            }
        };
        std::vector<Fade> fades;
        for (const Rgb& factor : factors) fades.push_back({factor, factor});
        const double now = static_cast<double>(frame) / rate;
        constexpr double rounding = 1e-9;
        for (const Cue& cue : cues) {
            if (cue.time > now + rounding) break;
            for (const auto& [lamp, look] : cue.looks)
                fades[lamp] = {fades[lamp].at(cue.time), look, cue.time, cue.fade};
        }
        for (std::size_t i = 0; i < factors.size(); ++i) factors[i] = fades[i].at(now);
    }

    std::vector<Cue> cues;
    double rate = 25;
};

/// Reads either kind of table.
class TableReader {
public:
    TableReader(std::string_view text, const std::string& path, const LampNames& names,
                Diagnostics& diagnostics)
        : path_(path), names_(names), diagnostics_(diagnostics) {
        for (std::size_t line = 1; !text.empty(); ++line) {
            const std::string_view row = text.substr(0, text.find('\n'));
            text.remove_prefix(std::min(row.size() + 1, text.size()));
            if (!bare(row).empty()) lines_.emplace_back(line, row);
        }
        // Names in a header have no other separators.
        for (const char each : {';', '\t', '|'})
            if (!lines_.empty() && lines_[0].second.find(each) != std::string_view::npos)
                separator_ = each;
    }

    std::unique_ptr<ShowFrames> read(double rate) {
        if (lines_.empty()) return fail("has no rows"), nullptr;
        if (!cells_of(0)) return nullptr;
        if (lower_case(std::string(bare(cells_[0]))) == "cue") return cues(rate);
        return table();
    }

private:
    bool fail(const std::string& why, std::string help = {}) {
        diagnostics_.add(error(Fault::option, {}, message("`", printable(path_), "` ", why))
                             .with_help(std::move(help)));
        return false;
    }

    bool fail_at(std::size_t row, const std::string& why, std::string_view help = {}) {
        diagnostics_.add(
            error(Fault::option, {},
                  message("`", printable(path_), "`, line ", lines_[row].first, ": ", why))
                .with_help(std::string(help)));
        return false;
    }

    /// Divides a row into its cells.
    bool cells_of(std::size_t row) {
        CsvForm form;
        form.header = CsvForm::Header::none;
        form.text = true;
        form.separator = separator_;
        CsvProblem problem;
        auto table = read_csv(lines_[row].second, form, most_cells, problem);
        if (!table) return fail_at(row, problem.too_many ? "too many cells" : problem.message);
        cells_ = std::move(table->cells);
        return true;
    }

    std::unique_ptr<ShowFrames> table() {
        auto made = std::make_unique<TableFrames>();
        std::vector<bool> counts;  // whether a column of the file is one of lamps
        for (const std::string& cell : std::vector<std::string>(cells_)) {
            const std::string_view name = bare(cell);
            const std::string word = lower_case(std::string(name));
            counts.push_back(word != "frame" && word != "time");
            if (!counts.back()) continue;
            const auto lamps = names_.chosen(name, diagnostics_);
            if (!lamps) return nullptr;
            if (name.find("..") == name.npos) {
                made->columns.push_back(*lamps);
                continue;
            }
            counts.insert(counts.end(), lamps->size() - 1, true);
            for (const std::uint32_t lamp : *lamps) made->columns.push_back({lamp});
        }
        made->rows = lines_.size() - 1;
        if (made->rows == 0) return fail("has a header and no row"), nullptr;
        if (made->columns.size() > most_cells / made->rows)
            return fail(message("has more than ", most_cells, " cells"),
                        "a show of so many lamps fits into an FSEQ file: --fseq"),
                   nullptr;
        for (std::size_t row = 1; row < lines_.size(); ++row)
            if (!add_frame(row, counts, *made)) return nullptr;
        return made;
    }

    bool add_frame(std::size_t row, const std::vector<bool>& counts, TableFrames& made) {
        if (!cells_of(row)) return false;
        if (cells_.size() != counts.size())
            return fail_at(row,
                           message(cells_.size(), cells_.size() == 1 ? " cell" : " cells",
                                   ", and the header has ", counts.size()),
                           "a range such as Bulb[0..9] has a column for each of its lamps");
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            if (!counts[i]) continue;
            const std::string_view cell = bare(cells_[i]);
            const auto factor = cell.empty() ? std::optional(Rgb(-1)) : lamp_factor(cell);
            if (!factor)
                return fail_at(row, message("`", printable(cell), "` is no value of a lamp"),
                               value_rule);
            made.cells.push_back({static_cast<float>(factor->r), static_cast<float>(factor->g),
                                  static_cast<float>(factor->b)});
        }
        return true;
    }

    std::unique_ptr<ShowFrames> cues(double rate) {
        constexpr std::string_view form = "cue, time, fade, Lamp=0.5, Other=#ff8800 ...";
        constexpr std::array<std::string_view, 3> words = {"cue", "time", "fade"};
        for (std::size_t i = 0; i < words.size(); ++i)
            if (i >= cells_.size() || lower_case(std::string(bare(cells_[i]))) != words[i])
                return fail_at(0, "a cue list has the columns cue, time and fade", form), nullptr;
        auto made = std::make_unique<CueFrames>();
        made->rate = rate;
        for (std::size_t row = 1; row < lines_.size(); ++row)
            if (!add_cue(row, *made)) return nullptr;
        if (made->cues.empty()) return fail("has a header and no cue"), nullptr;
        return made;
    }

    bool add_cue(std::size_t row, CueFrames& made) {
        if (!cells_of(row)) return false;
        const auto seconds = [&](std::size_t i) {
            const auto number = i < cells_.size() ? finite_number(bare(cells_[i])) : std::nullopt;
            return number && *number >= 0 ? number : std::nullopt;
        };
        CueFrames::Cue cue;
        const auto time = seconds(1), fade = seconds(2);
        if (!time || !fade)
            return fail_at(row, "the time and the fade of a cue are seconds, from 0 on");
        if ((*time + *fade) * made.rate >= static_cast<double>(most_show_frames))
            return fail_at(row, message("a show has up to ", most_show_frames, " frames"));
        if (!made.cues.empty() && *time < made.cues.back().time)
            return fail_at(row, "the cue is earlier than the one before it");
        cue.time = *time;
        cue.fade = *fade;
        for (std::size_t i = 3; i < cells_.size(); ++i) {
            const std::string cell(bare(cells_[i]));
            if (cell.empty()) continue;
            const std::size_t equals = cell.rfind('=');
            const auto factor =
                equals == cell.npos ? std::nullopt : lamp_factor(bare(cell).substr(equals + 1));
            if (!factor)
                return fail_at(row, message("`", printable(cell), "` is no lamp with its value"),
                               value_rule);
            const auto lamps =
                names_.chosen(bare(std::string_view(cell).substr(0, equals)), diagnostics_);
            if (!lamps) return false;
            for (const std::uint32_t lamp : *lamps) cue.looks.emplace_back(lamp, *factor);
        }
        made.cues.push_back(std::move(cue));
        return true;
    }

    const std::string& path_;
    const LampNames& names_;
    Diagnostics& diagnostics_;
    std::vector<std::pair<std::size_t, std::string_view>> lines_;  ///< that are not empty
    std::vector<std::string> cells_;                               ///< of the current row
    char separator_ = ',';
};

}  // namespace

std::unique_ptr<ShowFrames> show_of_table(std::string_view text, const std::string& path,
                                          const LampNames& names, double rate,
                                          Diagnostics& diagnostics) {
    return TableReader(text, path, names, diagnostics).read(rate);
}

std::unique_ptr<ShowFrames> read_show_table(const std::string& path, const LampNames& names,
                                            double rate, Diagnostics& diagnostics) {
    const auto text = content_of_file(path, most_table_bytes);
    if (text) return show_of_table(*text, path, names, rate, diagnostics);
    diagnostics.add(error(Fault::io, {}, message("`", printable(path), "` cannot be read")));
    return nullptr;
}

bool LightShow::set(std::string_view text, Diagnostics& diagnostics) {
    const std::size_t equals = text.rfind('=');
    const auto factor =
        equals == text.npos || equals == 0 ? std::nullopt : lamp_factor(text.substr(equals + 1));
    if (!factor) {
        diagnostics.add(error(Fault::option, {},
                              message("`--set ", printable(text), "` is no lamp with its value"))
                            .with_help("--set Lamp=0.5, --set Lamp=#ff8800, or --set "
                                       "'Lamps[17]=0.5,#ff8800'"));
        return false;
    }
    auto lamps = names_.chosen(text.substr(0, equals), diagnostics);
    if (!lamps) return false;
    fixed_.push_back({std::move(*lamps), *factor});
    return true;
}

std::vector<Rgb> LightShow::factors(std::size_t frame) const {
    std::vector<Rgb> factors(names_.lamps().size(), Rgb(1));
    if (frames_) frames_->set(frame, factors);
    for (const Fixed& fixed : fixed_)
        for (const std::uint32_t lamp : fixed.lamps) factors[lamp] = fixed.factor;
    return factors;
}

}  // namespace candelabra
