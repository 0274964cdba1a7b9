// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/option_table.h"
#include "options/option_values.h"
#include "proof/laws.h"
#include "scene/settings.h"
#include "support/shell.h"

#include <algorithm>
#include <functional>

namespace candelabra::proof {

namespace {

using Words = std::vector<std::string>;

/// The words of a command line that give the options of a script.
Words words_of_options(const std::vector<RunOption>& options) {
    Words words;
    for (const RunOption& each : options)
        for (const OptionRow& row : option_table())
            if (row.field == RenderSettings::vocabulary.fields[each.field].name) {
                Options given;
                RenderSettings::vocabulary.set(&given.render, each.field, each.value);
                for (const std::string& value : values_in_force(row, given))
                    for (std::string& word : words_of(row, value)) words.push_back(std::move(word));
            }
    return words;
}

/// A file as an image, three bytes in a pixel.
Image image_of(const std::string& bytes) {
    Image image(static_cast<int>((bytes.size() + 2) / 3), 1);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        image.pixels[i / 3][static_cast<int>(i % 3)] = static_cast<unsigned char>(bytes[i]);
    return image;
}

/// What the program makes beside the scene: a kind of picture, by more options, and the light of each
/// lamp.
struct Wish {
    std::string ending;
    Words more = {};
    bool keeps_lights = false;
};

/// The program in a folder with the scene.
class Program {
public:
    Program(const Script& script, const Wish& wish, const Deadline& end)
        : ending_(wish.ending), keeps_lights_(wish.keeps_lights), end_(end) {
        shell_.library = std::string(CANDELABRA_SOURCE_DIR) + "/stdlib";
        shell_.interrupts.take = [this] {
            return end_.over() || (patience_ > 0 && --patience_ == 0) ? Interrupt::stop
                                                                      : Interrupt::none;
        };
        shell_.write("scene.pov", written(script));
        words_ = {shell_.path("scene.pov"), "-V", "+W24", "+H18", "--seed", "3"};
        words_.push_back("+L" + std::string(CANDELABRA_SOURCE_DIR) + "/tests/conformance/pictures");
        const Words options = words_of_options(script.options);
        words_.insert(words_.end(), options.begin(), options.end());
        words_.insert(words_.end(), wish.more.begin(), wish.more.end());
    }

    std::string file(const std::string& name) const { return shell_.path(name + ending_); }
    /// Whether the last run, which was stopped, left a state, or had not come to a sample.
    bool has_state(const std::string& name) const {
        return std::filesystem::exists(file(name) + ".state.exr") ||
               shell_.err.find("stopped before the first sample") != std::string::npos;
    }

    /// Renders into a file of that name. Returns the exit status.
    int render(const std::string& name, const Words& more) {
        Words all = words_;
        all.push_back("+O" + file(name));
        keep_lights(name, all);
        all.insert(all.end(), more.begin(), more.end());
        return shell_(all);
    }
    /// The same, which a signal stops after so many questions for one.
    int render_for(int questions, const std::string& name, const Words& more) {
        patience_ = questions;
        const int status = render(name, more);
        patience_ = 0;
        return status;
    }
    int merge(const std::string& name, const Words& states) {
        Words all = {"merge", "-V", "+O" + file(name)};
        keep_lights(name, all);
        all.insert(all.end(), states.begin(), states.end());
        return shell_(all);
    }
    /// The picture, and the light of each lamp if it is kept.
    std::string content(const std::string& name) const {
        return shell_.content(name + ending_) + shell_.content(name + lights);
    }
    bool too_slow() const { return end_.over(); }

private:
    static constexpr const char* lights = ".lights";

    void keep_lights(const std::string& name, Words& words) const {
        if (!keeps_lights_) return;
        words.push_back("--keep-lights");
        words.push_back(shell_.path(name + lights));
    }

    Shell shell_;
    std::string ending_;
    bool keeps_lights_;
    const Deadline& end_;
    Words words_;
    int patience_ = 0;
};

/// Makes the file `picture` with a number of samples; returns false if it did not come to be.
using Way = std::function<bool(Program&, const std::string& samples)>;

bool at_once(Program& program, const std::string& samples) {
    return program.render("picture", {"--samples", samples}) == exit_status::done;
}

/// In three shares of the samples or of the tiles, which are merged.
bool in_shards(Program& program, const std::string& samples, const std::string& by) {
    Words states;
    for (int i = 3; i >= 1; --i) {
        const std::string number = std::to_string(i);
        const int status = program.render("part", {"--samples", samples, "--shard", number + "/3",
                                                   "--shard-by", by, "--threads", number});
        if (status != exit_status::done) return false;
        states.push_back(program.file("part") + "." + number + "of3.state.exr");
    }
    return program.merge("picture", states) == exit_status::done;
}

/// Stopped again and again, each time with a state that the next run goes on from.
bool in_pieces(Program& program, const std::string& samples) {
    for (int questions = 2; !program.too_slow(); questions += 2) {
        const int status = program.render_for(
            questions, "picture",
            {"--samples", samples, "+C", "--threads", std::to_string(questions % 3 + 1)});
        if (status == exit_status::done) return true;
        if (status != exit_status::stopped) return false;
        if (!program.has_state("picture")) return false;
    }
    return false;
}

/// A finished picture with fewer samples, which gets more.
bool with_more_samples(Program& program, const std::string& samples) {
    return program.render("picture", {"--samples", "2", "--keep-state"}) == exit_status::done &&
           program.render("picture", {"--samples", samples, "+C"}) == exit_status::done;
}

/// What the program makes that way, byte by byte. What it does not make has no pixels but one.
View made(const Script& script, const Wish& wish, const Way& way) {
    return [=](const Prepared&, int, int, const Deadline& end) {
        Program program(script, wish, end);
        const bool good = way(program, "4");
        if (program.too_slow()) return Image();
        return good ? image_of(program.content("picture")) : Image(1, 1);
    };
}

}  // namespace

Claims other_programs(const Script& script, Dice& dice) {
    Wish wish;
    wish.ending = dice.pick<std::string>({".png", ".exr", ".ppm", ".jpg"});
    if (dice.chance(0.3)) wish.more.push_back("--denoise");
    if (wish.ending == ".exr" && dice.chance(0.5))
        wish.more = {"--layers",
                     dice.pick<std::string>({"normal,albedo,lights", "depth,object,variance",
                                             "samples,shadow_rays,lights", "all"})};
    const bool may_keep_lights = dice.chance(0.3);
    const auto made_so = [&](const Way& way) {
        std::vector<Term> terms = picture(script);
        terms.front().view = made(script, wish, way);
        return terms;
    };
    const auto claim = [&](const std::string& name, const Way& way) {
        const std::string what = name + ", " + wish.ending + (wish.keeps_lights ? " + lights" : "");
        return Claims{same_bytes(what, made_so(at_once), made_so(way))};
    };
    switch (dice.below(4)) {
        case 0:
            return claim("more samples", with_more_samples);
        case 1:
            wish.keeps_lights = may_keep_lights;
            return claim("stopped and gone on", in_pieces);
        default:
            const std::string by = dice.pick<std::string>({"samples", "tiles"});
            // Shards by samples do not keep the light of lamps.
            wish.keeps_lights = may_keep_lights && by == "tiles";
            return claim("shards by " + by, [by](Program& program, const std::string& samples) {
                return in_shards(program, samples, by);
            });
    }
}

}  // namespace candelabra::proof
