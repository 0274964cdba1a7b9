// SPDX-License-Identifier: GPL-3.0-or-later
// Tries laws on scene after scene until the time is over or as many scenes have been tried.
#pragma once

#include "proof/verdict.h"

#include <functional>
#include <optional>
#include <string>

namespace candelabra::proof {

struct Plan {
    std::vector<const Law*> laws;
    std::uint64_t seed = 1;
    double minutes = 1e9;
    int scenes = 1 << 30;       ///< of each law
    double shrink_minutes = 2;  ///< for each fault
    bool until_fault = false;   ///< ends with the first fault
    Studio studio = {};
};

struct Fault {
    std::string law;
    Verdict verdict;
    std::string row;          ///< the levels of the scene that showed it
    std::string script = {};  ///< shrunk, with its head: see case_text()
    std::string known = {};   ///< name of a known fault; empty: it is new
};

struct LawCount {
    std::string_view law;
    int scenes = 0, failed = 0, known = 0, undecided = 0, slow = 0, illegal = 0;
    std::size_t covered = 0, pairs = 0;
    double seconds = 0;  ///< of the processor
};

/// A scene that was tried.
struct Tried {
    const Law& law;
    int number;  ///< of the scene, from 0
    const Verdict& verdict;
    double seconds;      ///< of the processor
    std::string script;  ///< with its head: see case_text()
};

struct Listening {
    std::function<void(const Fault&)> fault = {};
    /// Each scene before it is tried: what was tried last when the program ends by itself.
    std::function<void(const std::string& law, const std::string& text)> scene = {};
    std::function<void(const std::string& law, const std::string& complaint)> illegal = {};
    std::function<void(const Tried&)> tried = {};
    /// The counts so far, after a scene of each law.
    std::function<void(const std::vector<LawCount>&)> round = {};
};

std::vector<LawCount> run(const Plan&, const Listening&);

/// A scene of a law, as the run makes it.
struct Trial {
    Row row;
    std::uint64_t seed;
    Script script;
};
Trial trial(const Law&, const Covering&, std::uint64_t seed, int number);

/// A script as a file: with the law, the seed of its claims and the options in its head.
std::string case_text(const Law&, std::uint64_t seed, const Script&, const std::string& figures);
/// The law, the seed and the script of such a file; nothing if its head names no law.
struct Case {
    const Law* law;
    std::uint64_t seed;
    Script script;
};
std::optional<Case> case_of(const std::string& text);

}  // namespace candelabra::proof
