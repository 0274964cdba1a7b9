// SPDX-License-Identifier: GPL-3.0-or-later
// What it costs to read scenes, beside POV-Ray where it is installed. Run by hand:
//     language_bench FOLDER
// For each script of the folder: CPU seconds of candelabra --check as a whole, those that it and
// POV-Ray each say their parsing has taken, the ratio of these two, and the geometric mean of the
// ratios; then, on scenes that it writes itself: a mesh2 of a million triangles, and a million
// spheres from a loop, with the peaks of memory of reading them and of rendering them very small.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// What a run of a program has cost.
struct Run {
    bool good = false;
    double cpu_seconds = 0;
    double peak_megabytes = 0;
    std::string said;
};

double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

[[noreturn]] void become(const fs::path& folder, std::vector<std::string> command, int output) {
    dup2(output, 1);
    dup2(output, 2);
    std::vector<char*> arguments;
    for (std::string& each : command) arguments.push_back(each.data());
    arguments.push_back(nullptr);
    if (chdir(folder.c_str()) == 0) execvp(arguments[0], arguments.data());
    _exit(127);
}

Run run(const fs::path& folder, const std::vector<std::string>& command) {
    Run result;
    int ends[2];
    if (pipe(ends) != 0) return result;
    const pid_t child = fork();
    if (child == 0) become(folder, command, ends[1]);
    close(ends[1]);
    char buffer[4096];
    for (ssize_t n; (n = read(ends[0], buffer, sizeof buffer)) > 0;)
        result.said.append(buffer, static_cast<std::size_t>(n));
    close(ends[0]);
    int status = 0;
    rusage used{};
    wait4(child, &status, 0, &used);
    result.good = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    result.cpu_seconds = seconds(used.ru_utime) + seconds(used.ru_stime);
    result.peak_megabytes = static_cast<double>(used.ru_maxrss) / 1024;
    return result;
}

/// The cheapest of three runs: what others do on the machine only adds.
Run cheapest(const fs::path& folder, const std::vector<std::string>& command) {
    Run best = run(folder, command);
    for (int i = 0; i < 2; ++i) {
        Run next = run(folder, command);
        if (next.cpu_seconds < best.cpu_seconds) best = std::move(next);
    }
    return best;
}

Run check(const fs::path& scene) {
    return cheapest(scene.parent_path(), {CANDELABRA_BINARY, "--check", scene.filename()});
}

/// What it says that its parsing has taken.
double parse(const fs::path& scene) {
    const fs::path said =
        fs::temp_directory_path() / ("language_bench_" + std::to_string(getpid()));
    double least = HUGE_VAL;
    for (int i = 0; i < 3; ++i) {
        run(scene.parent_path(), {CANDELABRA_BINARY, "--check", "--stats", said, scene.filename()});
        std::ostringstream text;
        text << std::ifstream(said).rdbuf();
        const std::string json = text.str();
        const std::size_t at = json.find("\"parse\":", json.find("\"cpu_seconds\""));
        if (at != std::string::npos) least = std::min(least, std::strtod(&json[at + 8], nullptr));
        fs::remove(said);
    }
    return least;
}

/// What POV-Ray says that its parsing has taken; nothing when it is not there or has failed.
std::optional<double> povray_parse(const fs::path& scene) {
    const Run done = cheapest(scene.parent_path(), {"povray", "+I" + scene.filename().string(),
                                                    "+W8", "+H6", "-D", "-F", "+WT1"});
    const std::size_t phase = done.said.find("Parse Time");
    const std::size_t cpu = done.said.find("thread(s) with ", phase);
    if (!done.good || phase == std::string::npos || cpu == std::string::npos) return std::nullopt;
    return std::strtod(done.said.c_str() + cpu + 15, nullptr);
}

/// POV-Ray's clock is too coarse for less.
constexpr double min_compared = 0.02;

void compare(const fs::path& folder) {
    std::vector<fs::path> scenes;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".pov") scenes.push_back(fs::absolute(entry.path()));
    std::sort(scenes.begin(), scenes.end());
    std::printf("| script | CPU s | of parsing | POV-Ray's | ratio |\n|---|---|---|---|---|\n");
    double logarithms = 0, of_all = 0, least = HUGE_VAL;
    int compared = 0;
    for (const fs::path& scene : scenes) {
        const Run ours = check(scene);
        const std::optional<double> theirs = povray_parse(scene);
        const double parsing = ours.good ? parse(scene) : HUGE_VAL;
        std::printf("| `%s` | ", scene.stem().c_str());
        std::printf(ours.good ? "%.3f | %.4f | " : "fails | | ", ours.cpu_seconds, parsing);
        std::printf(theirs ? "%.3f | " : "fails | ", theirs.value_or(0));
        if (ours.good && theirs && *theirs >= min_compared) {
            const double ratio = *theirs / parsing;
            std::printf("%.1f |\n", ratio);
            logarithms += std::log(ratio);
            of_all += std::log(*theirs / ours.cpu_seconds);
            least = std::min(least, ratio);
            ++compared;
        } else {
            std::printf("|\n");
        }
        std::fflush(stdout);
    }
    if (compared > 0)
        std::printf(
            "\n%d compared: least ratio %.1f, geometric mean %.1f; with all that candelabra does, "
            "from its start to its end, %.1f\n",
            compared, least, std::exp(logarithms / compared), std::exp(of_all / compared));
}

constexpr const char* start =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location <0, 3, -5> look_at 0 }\n"
    "light_source { <10, 20, -30>, 1 }\n";

/// A wavy sheet of 707 by 707 squares.
void write_mesh(const fs::path& path) {
    constexpr int side = 708;
    std::FILE* file = std::fopen(path.c_str(), "w");
    if (!file) return;
    std::fprintf(file, "%smesh2 {\n  vertex_vectors { %d", start, side * side);
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j)
            std::fprintf(file, ",\n<%.6f,%.6f,%.6f>", double(i) / side - 0.5,
                         0.1 * std::sin(i * 0.05) * std::cos(j * 0.04), double(j) / side - 0.5);
    std::fprintf(file, " }\n  face_indices { %d", 2 * (side - 1) * (side - 1));
    for (int i = 0; i + 1 < side; ++i)
        for (int j = 0; j + 1 < side; ++j) {
            const int a = i * side + j;
            std::fprintf(file, ",\n<%d,%d,%d>,<%d,%d,%d>", a, a + 1, a + side, a + 1, a + side + 1,
                         a + side);
        }
    std::fprintf(file, " }\n  pigment { rgb 1 }\n}\n");
    std::fclose(file);
}

void write_spheres(const fs::path& path) {
    std::ofstream(path) << start
                        << "#declare R = seed(1);\nunion { #for (I, 1, 1000000) sphere { "
                           "<rand(R), rand(R), rand(R)>*40 - 20, 0.05 } #end pigment { rgb 1 } }\n";
}

void weigh(const char* name, const fs::path& scene) {
    const Run read = check(scene);
    const Run rendered = run(scene.parent_path(), {CANDELABRA_BINARY, "+W8", "+H6", "-A",
                                                   "--samples", "1", "-F", scene.filename()});
    const double megabytes = static_cast<double>(fs::file_size(scene)) * 1e-6;
    std::printf(
        "\n%s: %s%.3f CPU s (%.0f MB/s), peak %.0f MB; rendered: %s%.2f CPU s, peak %.0f "
        "MB\n",
        name, read.good ? "" : "FAILS ", read.cpu_seconds, megabytes / read.cpu_seconds,
        read.peak_megabytes, rendered.good ? "" : "FAILS ", rendered.cpu_seconds,
        rendered.peak_megabytes);
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2 || !fs::is_directory(arguments[1])) {
        std::fprintf(stderr, "language_bench FOLDER\n");
        return 2;
    }
    compare(arguments[1]);
    std::string pattern = (fs::temp_directory_path() / "language_bench_XXXXXX").string();
    if (!mkdtemp(pattern.data())) return 3;
    const fs::path folder = pattern;
    write_mesh(folder / "mesh.pov");
    write_spheres(folder / "spheres.pov");
    weigh("mesh2 of a million triangles", folder / "mesh.pov");
    weigh("a million spheres", folder / "spheres.pov");
    fs::remove_all(folder);
    return 0;
}
