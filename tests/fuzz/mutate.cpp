// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a fuzz target where there is no libFuzzer: over files, and over a number of mutations of
// them that are the same in every run. mutate COUNT DICTIONARY FILE...
#include "fuzz/target.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace {

using Random = std::mt19937;

std::string read(const char* path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t below(Random& random, std::size_t limit) { return limit ? random() % limit : 0; }

/// One change: bytes left out, doubled or altered, a word put in, or a piece of another text.
void mutate(std::string& text, const std::vector<std::string>& words,
            const std::vector<std::string>& texts, Random& random) {
    const std::size_t at = below(random, text.size() + 1);
    const std::size_t length = below(random, 1 + std::min<std::size_t>(40, text.size() - at));
    switch (below(random, 5)) {
        case 0:
            text.erase(at, length);
            break;
        case 1:
            text.insert(at, text.substr(at, length));
            break;
        case 2:
            if (at < text.size()) text[at] = static_cast<char>(random());
            break;
        case 3:
            text.insert(at, " " + words[below(random, words.size())] + " ");
            break;
        default: {
            const std::string& other = texts[below(random, texts.size())];
            text.insert(at, other.substr(below(random, other.size()), below(random, 60)));
        }
    }
}

void run(const std::string& text) {
    // Where the process dies, this file has what it died of.
    std::ofstream("fuzz-input.pov", std::ios::binary) << text;
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 4) return std::cerr << "usage: mutate COUNT DICTIONARY FILE...\n", 2;
    std::vector<std::string> words, texts;
    std::ifstream dictionary(arguments[2]);
    for (std::string line; std::getline(dictionary, line);)
        if (line.size() > 2) words.push_back(line.substr(1, line.size() - 2));
    for (int i = 3; i < count; ++i) texts.push_back(read(arguments[i]));
    if (words.empty()) return std::cerr << "the dictionary is empty\n", 2;
    for (const std::string& text : texts) run(text);
    Random random(1);
    const long mutations = std::atol(arguments[1]);
    for (long i = 0; i < mutations; ++i) {
        std::string text = texts[below(random, texts.size())];
        for (std::size_t n = 1 + below(random, 6); n > 0; --n) mutate(text, words, texts, random);
        run(text);
    }
    std::filesystem::remove("fuzz-input.pov");
    std::cout << texts.size() << " files and " << mutations << " mutations\n";
}
