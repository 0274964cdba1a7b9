// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/runner.h"

#include "base/random.h"
#include "proof/known.h"
#include "proof/shrink.h"
#include "scene/settings.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <sstream>

namespace candelabra::proof {

namespace {

using Clock = std::chrono::steady_clock;

double minutes_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count() / 60;
}

double seconds_of_processor() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

class Run {
public:
    Run(const Plan& plan, const Listening& listening) : plan_(plan), listening_(listening) {
        for (const Law* law : plan.laws) {
            coverings_.emplace_back(levels_without(law->without));
            counts_.push_back({law->name});
            counts_.back().pairs = coverings_.back().pairs();
        }
    }

    std::vector<LawCount> run() {
        const auto begin = Clock::now();
        for (int number = 0; number < plan_.scenes; ++number) {
            for (std::size_t i = 0; i < plan_.laws.size(); ++i) {
                if (minutes_since(begin) > plan_.minutes) return counts();
                const double before = seconds_of_processor();
                attempt(i, number, before);
                counts_[i].seconds += seconds_of_processor() - before;
                if (plan_.until_fault && counts_[i].failed > 0) return counts();
            }
            if (listening_.round) listening_.round(counts());
        }
        return counts();
    }

private:
    void attempt(std::size_t i, int number, double before) {
        const Law& law = *plan_.laws[i];
        const Trial tried = trial(law, coverings_[i], plan_.seed, number);
        if (listening_.scene)
            listening_.scene(std::string(law.name), case_text(law, tried.seed, tried.script, ""));
        const Verdict verdict = judged(law, tried.script, tried.seed, plan_.studio);
        if (listening_.tried)
            listening_.tried({law, number, verdict, seconds_of_processor() - before,
                              case_text(law, tried.seed, tried.script, described(verdict))});
        LawCount& count = counts_[i];
        ++count.scenes;
        switch (verdict.outcome) {
            case Outcome::holds:
                break;
            case Outcome::fails:
                found(law, tried, verdict, count);
                break;
            case Outcome::undecided:
                ++count.undecided;
                break;
            case Outcome::too_slow:
                ++count.slow;
                return;
            case Outcome::illegal:
                ++count.illegal;
                if (listening_.illegal) listening_.illegal(std::string(law.name), verdict.said);
                coverings_[i].cover(tried.row);  // or it would be made again and again
                return;
        }
        coverings_[i].cover(tried.row);
    }

    void found(const Law& law, const Trial& tried, const Verdict& verdict, LawCount& count) {
        Fault fault{std::string(law.name), verdict, described_row(tried.row)};
        fault.known = known_fault(law.name, tried.script);
        ++(fault.known.empty() ? count.failed : count.known);
        Script small = tried.script;
        if (fault.known.empty()) {
            const auto begin = Clock::now();
            small = shrunk(tried.script, [&](const Script& smaller) {
                if (minutes_since(begin) > plan_.shrink_minutes) return false;
                const Verdict again = judged(law, smaller, tried.seed, plan_.studio);
                if (again.outcome == Outcome::fails) fault.verdict = again;
                return again.outcome == Outcome::fails;
            });
        }
        fault.script = case_text(law, tried.seed, small, described(fault.verdict));
        if (listening_.fault) listening_.fault(fault);
    }

    std::vector<LawCount> counts() {
        for (std::size_t i = 0; i < counts_.size(); ++i)
            counts_[i].covered = coverings_[i].covered();
        return counts_;
    }

    const Plan& plan_;
    const Listening& listening_;
    std::vector<Covering> coverings_;
    std::vector<LawCount> counts_;
};

}  // namespace

Trial trial(const Law& law, const Covering& covering, std::uint64_t seed, int number) {
    const auto place = static_cast<std::uint64_t>(&law - laws().data());
    const std::uint64_t own = mix(mix(seed) + 1000 * place) + static_cast<std::uint64_t>(number);
    Dice dice(mix(own));
    Trial result{covering.next(dice), dice.next() >> 32, {}};
    Draft draft = drafted(result.row, result.seed);
    result.script = law.stage(draft);
    return result;
}

std::vector<LawCount> run(const Plan& plan, const Listening& listening) {
    return Run(plan, listening).run();
}

std::string case_text(const Law& law, std::uint64_t seed, const Script& script,
                      const std::string& figures) {
    std::string text = "// SPDX-License-Identifier: GPL-3.0-or-later\n// law " +
                       std::string(law.name) + ", seed " + std::to_string(seed) + "\n";
    if (!figures.empty()) text += "// " + figures + "\n";
    for (const RunOption& each : script.options)
        text += "// option " + std::string(RenderSettings::vocabulary.fields[each.field].name) +
                " " + text_of(each.value) + "\n";
    return text + written(script, {.marked = true});
}

std::optional<Case> case_of(const std::string& text) {
    std::istringstream lines(text);
    std::optional<Case> result;
    std::vector<RunOption> options;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string slashes, kind, name, seed_word;
        words >> slashes >> kind >> name;
        if (slashes != "//") continue;
        if (kind == "law") {
            name.pop_back();  // the comma
            const auto law = std::ranges::find(laws(), name, &Law::name);
            std::uint64_t seed = 0;
            if (law != laws().end() && words >> seed_word >> seed) result = Case{&*law, seed, {}};
        } else if (kind == "option") {
            const auto fields = RenderSettings::vocabulary.fields;
            const auto field = std::ranges::find(fields, name, &FieldInfo::name);
            double value = 0;
            if (field != fields.end() && words >> value)
                options.push_back({static_cast<std::size_t>(field - fields.begin()), value});
        }
    }
    if (!result) return {};
    result->script = script_of(text);
    result->script.options = options;
    return result;
}

}  // namespace candelabra::proof
