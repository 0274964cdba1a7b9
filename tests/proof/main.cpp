// SPDX-License-Identifier: GPL-3.0-or-later
// The program that run.sh starts: tries laws for a while, and writes what breaks them.
//   proof [--minutes N] [--scenes N] [--law NAME]... [--seed S] [--out FOLDER] [--show]
//     [--first] [CASE.pov]...
#include "base/deep_stack.h"
#include "proof/runner.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace candelabra::proof {

namespace {

namespace fs = std::filesystem;

struct Asked {
    Plan plan;
    fs::path out = "proof.out";
    bool shows = false;  ///< prints each scene
    std::vector<std::string> cases = {};
};

std::string read(const std::string& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

const Law* law_named(std::string_view name) {
    const auto found = std::ranges::find(laws(), name, &Law::name);
    return found == laws().end() ? nullptr : &*found;
}

std::string table_of(const std::vector<LawCount>& counts) {
    std::ostringstream table;
    table
        << "| law | scenes | pairs | of | failed | known | undecided | too slow | illegal | CPU s "
           "|\n|---|---|---|---|---|---|---|---|---|---|\n";
    for (const LawCount& each : counts)
        table << "| " << each.law << " | " << each.scenes << " | " << each.covered << " | "
              << each.pairs << " | " << each.failed << " | " << each.known << " | "
              << each.undecided << " | " << each.slow << " | " << each.illegal << " | "
              << std::lround(each.seconds) << " |\n";
    return table.str();
}

bool take(Asked& asked, std::string_view option, const char* value) {
    if (option == "--minutes")
        asked.plan.minutes = std::atof(value);
    else if (option == "--scenes")
        asked.plan.scenes = std::atoi(value);
    else if (option == "--seed")
        asked.plan.seed = std::strtoull(value, nullptr, 10);
    else if (option == "--seconds")
        asked.plan.studio.seconds = asked.plan.studio.look_seconds = std::atof(value);
    else if (option == "--shrink")
        asked.plan.shrink_minutes = std::atof(value);
    else if (option == "--out")
        asked.out = value;
    else if (option == "--law" && law_named(value))
        asked.plan.laws.push_back(law_named(value));
    else
        return false;
    return true;
}

int usage() {
    std::fputs(
        "proof [--minutes N] [--scenes N] [--law NAME]... [--seed S] [--seconds N] [--shrink N]\n"
        "      [--out FOLDER] [--show] [--first] [CASE.pov]...\nlaws:\n",
        stderr);
    for (const Law& law : laws())
        std::fprintf(stderr, "  %-14s %s\n", std::string(law.name).c_str(),
                     std::string(law.says).c_str());
    return 2;
}

int try_case(const std::string& path, const Studio& studio) {
    const std::string text = read(path);
    if (const std::string trouble = trouble_with_braces(text); !trouble.empty())
        return std::fprintf(stderr, "%s: %s\n", path.c_str(), trouble.c_str()), 2;
    const auto found = case_of(text);
    if (!found)
        return std::fprintf(stderr, "%s has no line `// law NAME, seed N` with a law of proof\n",
                            path.c_str()),
               2;
    const Verdict verdict = judged(*found->law, found->script, found->seed, studio);
    std::printf("%s: %s\n", path.c_str(), described(verdict).c_str());
    return verdict.outcome == Outcome::holds ? 0 : 1;
}

int try_laws(Asked& asked) {
    if (asked.plan.laws.empty())
        for (const Law& law : laws()) asked.plan.laws.push_back(&law);
    fs::create_directories(asked.out);
    int faults = 0;
    Listening listening;
    listening.scene = [&](const std::string&, const std::string& text) {
        write(asked.out / "last.pov", text);
        if (asked.shows) std::puts(text.c_str());
    };
    listening.illegal = [&](const std::string& law, const std::string& complaint) {
        std::printf("%s: illegal: %s\n", law.c_str(), complaint.c_str());
    };
    listening.fault = [&](const Fault& fault) {
        if (fault.known.empty())
            write(asked.out / (fault.law + "-" + std::to_string(asked.plan.seed) + "-" +
                               std::to_string(++faults) + ".pov"),
                  fault.script);
        std::printf("%s %s\n  %s\n", fault.law.c_str(), described(fault.verdict).c_str(),
                    fault.known.empty() ? fault.row.c_str() : ("known: " + fault.known).c_str());
        std::fflush(stdout);
    };
    std::ofstream scenes(asked.out / "scenes.txt");
    listening.tried = [&](const Tried& tried) {
        scenes << tried.law.name << ' ' << tried.number << ' ' << tried.seconds << " s "
               << described(tried.verdict) << std::endl;
        const bool slow = tried.verdict.outcome == Outcome::too_slow;
        if (slow || tried.verdict.outcome == Outcome::undecided)
            write(asked.out / ((slow ? "slow-" : "undecided-") + std::string(tried.law.name) + "-" +
                               std::to_string(asked.plan.seed) + "-" +
                               std::to_string(tried.number) + ".pov"),
                  tried.script);
    };
    listening.round = [&](const std::vector<LawCount>& counts) {
        write(asked.out / "table.md", table_of(counts));
    };
    const std::string table = table_of(run(asked.plan, listening));
    write(asked.out / "table.md", table);
    std::fputs(table.c_str(), stdout);
    return faults > 0 ? 1 : 0;
}

int run_program(int count, char** arguments) {
    Asked asked;
    for (int i = 1; i < count; ++i) {
        const std::string_view word = arguments[i];
        if (word == "--show")
            asked.shows = true;
        else if (word == "--first")
            asked.plan.until_fault = true;
        else if (!word.starts_with("--"))
            asked.cases.emplace_back(word);
        else if (i + 1 == count || !take(asked, word, arguments[++i]))
            return usage();
    }
    int status = 0;
    for (const std::string& each : asked.cases)
        status = std::max(status, try_case(each, asked.plan.studio));
    return asked.cases.empty() ? try_laws(asked) : status;
}

}  // namespace

}  // namespace candelabra::proof

int main(int count, char** arguments) {
    int status = 0;
    candelabra::on_deep_stack(std::size_t{256} << 20, [&](std::size_t) {
        status = candelabra::proof::run_program(count, arguments);
    });
    return status;
}
