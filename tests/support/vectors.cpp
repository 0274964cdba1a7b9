// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/vectors.h"

#include "bind/evaluate.h"
#include "support/folder.h"
#include "text/excerpt.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace candelabra {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

const std::string prefix = R"(#version 3.7; global_settings{assumed_gamma 1}
#macro P(vv) #debug concat(str(vv,0,6)," ") #end
#macro V(nn,vv) #debug concat("<",vstr(nn,vv,",",0,4),"> ") #end
#macro I(o,pt) #debug concat(str(inside(o,pt),0,0)," ") #end
#macro E(o) V(3,min_extent(o)) V(3,max_extent(o)) #end
#macro Tr(o,a,b) #local nn=<0,0,0>; #local pp=trace(o,a,b,nn); #debug "T" V(3,pp) V(3,nn) #end
)";

std::string content_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

void write(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

struct Outcome {
    std::string printed;
    std::string said;  ///< all diagnostics
    bool failed = false;
};

Outcome run(const std::string& script, const fs::path& folder) {
    SourceStore sources;
    Diagnostics diagnostics;
    const std::string library = CANDELABRA_SOURCE_DIR "/stdlib";
    const FileAccess access({folder.string(), library}, {folder.string()});
    const Loader loader(scene_reader(access), folder.string(), {library}, access);
    Outcome outcome;
    EvaluateOptions options;
    options.facts.image_width = 8;
    options.facts.image_height = 6;
    options.print = [&](std::string_view text) { outcome.printed += text; };
    evaluate(sources, loader, sources.add((folder / "x.pov").string(), script), options,
             diagnostics);
    for (const Diagnostic& each : diagnostics.all()) outcome.said += format(each, sources, false);
    outcome.failed = diagnostics.failed();
    return outcome;
}

/// Blanks and line ends of any number as one blank, none around the text.
std::string squeezed(const std::string& text) {
    std::istringstream words(text);
    std::string result;
    for (std::string word; words >> word;) result += (result.empty() ? "" : " ") + word;
    return result;
}

/// The length of the number at the start of a text, and what one more in its last digit is worth.
struct Printed {
    std::size_t length = 0;
    double value = 0;
    double last_digit = 0;
};

Printed number_at(const std::string& text, std::size_t from) {
    const auto digits = [&](std::size_t i) {
        std::size_t n = 0;
        while (i + n < text.size() && std::isdigit(static_cast<unsigned char>(text[i + n]))) ++n;
        return n;
    };
    const std::size_t sign = from < text.size() && text[from] == '-' ? 1 : 0;
    const std::size_t whole = digits(from + sign);
    if (whole == 0) return {};
    Printed found{sign + whole, 0, 0};
    if (from + found.length < text.size() && text[from + found.length] == '.') {
        const std::size_t decimals = digits(from + found.length + 1);
        found.length += 1 + decimals;
        found.last_digit = std::pow(10.0, -static_cast<double>(decimals));
    }
    found.value = std::strtod(text.substr(from, found.length).c_str(), nullptr);
    return found;
}

/// Numbers may differ by one in their last printed digit.
bool same_text(const std::string& found, const std::string& expected) {
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < found.size() && j < expected.size()) {
        const Printed a = number_at(found, i);
        const Printed b = number_at(expected, j);
        if (a.length > 0 && b.length > 0) {
            if (a.last_digit != b.last_digit) return false;
            if (std::abs(a.value - b.value) > 1.01 * b.last_digit) return false;
            i += a.length;
            j += b.length;
        } else if (found[i++] != expected[j++]) {
            return false;
        }
    }
    return i == found.size() && j == expected.size();
}

std::string utf8(const std::string& bytes) {
    std::string text;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80)
            text += c;
        else
            text += {static_cast<char>(0xc0 | byte >> 6), static_cast<char>(0x80 | (byte & 0x3f))};
    }
    return text;
}

/// What differs, or nothing.
std::string difference(const Json& test, const std::string& head, const Json& files) {
    const Folder folder;
    for (const auto& [name, text] : files.items()) folder.put(name, text);
    const std::string whole = head + test["script"].get<std::string>();
    folder.put("x.pov", whole);
    const Outcome outcome = run(whole, folder.path());
    const bool fails = test.value("fails", false);
    if (outcome.failed != fails)
        return fails ? "no error, prints: " + outcome.printed : "fails:\n" + outcome.said;
    if (!fails && !same_text(squeezed(outcome.printed), squeezed(test.value("prints", ""))))
        return "prints: " + outcome.printed;
    if (test.contains("writes"))
        if (const std::string written = utf8(folder.get("o.txt"));
            written != test["writes"].get<std::string>())
            return "writes: " + written;
    return {};
}

/// Whether the script's `unmatched` is as it should be; takes it away when told to.
void check(Json& test, const std::string& head, const Json& files, bool update) {
    const std::string difference_found = difference(test, head, files);
    const bool listed = test.contains("unmatched");
    INFO(test["script"].get<std::string>());
    if (listed) {
        const auto reason = test["unmatched"].get<std::string>();
        CHECK((reason.starts_with("not yet: ") || reason.starts_with("deliberate: ")));
        if (difference_found.empty() && update)
            test.erase("unmatched");
        else if (difference_found.empty())
            FAIL_CHECK("agrees now: take `unmatched` away (UPDATE_EXPECTED=1 does)");
    } else if (!difference_found.empty()) {
        FAIL_CHECK(difference_found);
    }
}

}  // namespace

std::size_t check_scripts(const std::string& folder) {
    const bool update = std::getenv("UPDATE_EXPECTED") != nullptr;
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(CANDELABRA_SOURCE_DIR "/tests/" + folder)) {
        const std::string text = content_of(entry.path());
        Json group = Json::parse(text);
        INFO(entry.path().filename());
        const std::string head = group.value("prefix", prefix);
        for (Json& test : group["scripts"]) {
            check(test, test.value("prefix", head), group.value("files", Json::object()), update);
            ++count;
        }
        if (const std::string now = group.dump(1) + "\n"; update && now != text)
            write(entry.path(), now);
    }
    return count;
}

}  // namespace candelabra
