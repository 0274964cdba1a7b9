// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sandbox.h"

#include "app/child.h"
#include "tasks/library.h"
#include "console/console.h"
#include "options/output.h"
#include "text/scene_folders.h"
#include "text/written_name.h"

#include <array>
#include <filesystem>
#include <span>
#include <system_error>

#include <fcntl.h>
#include <linux/landlock.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t reading = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t running = LANDLOCK_ACCESS_FS_EXECUTE;
/// Rights of the second and the third version of Landlock, which older headers lack.
constexpr std::uint64_t moving = 1 << 13, truncating = 1 << 14;
constexpr std::uint64_t writing = LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_REMOVE_DIR |
                                  LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_CHAR |
                                  LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG |
                                  LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO |
                                  LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SYM;
/// Rights that a rule for a single file may contain.
constexpr std::uint64_t of_files =
    LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE | running | truncating;

/// A Landlock ruleset under construction.
class Landlock {
public:
    Landlock() {
        const long version =
            ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
        if (version < 1) return;
        handled_ = reading | running | writing | (version >= 2 ? moving : 0) |
                   (version >= 3 ? truncating : 0);
        landlock_ruleset_attr attributes{};
        attributes.handled_access_fs = handled_;
        rules_ = static_cast<int>(
            ::syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes, 0));
    }
    ~Landlock() {
        if (rules_ >= 0) ::close(rules_);
    }
    Landlock(const Landlock&) = delete;
    Landlock& operator=(const Landlock&) = delete;

    bool works() const { return rules_ >= 0; }

    void allow(const std::string& path, std::uint64_t rights) const {
        const int file = ::open(path.c_str(), O_PATH | O_CLOEXEC);
        if (file < 0) return;
        std::error_code none;
        landlock_path_beneath_attr rule{};
        rule.parent_fd = file;
        rule.allowed_access = handled_ & rights & (fs::is_directory(path, none) ? ~0ull : of_files);
        ::syscall(SYS_landlock_add_rule, rules_, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
        ::close(file);
    }

    bool enforce() const { return ::syscall(SYS_landlock_restrict_self, rules_, 0) == 0; }

private:
    std::uint64_t handled_ = 0;
    int rules_ = -1;
};

bool confine_files(const SandboxRules& rules) {
    const Landlock landlock;
    if (!landlock.works()) return false;
    // Keeps /proc/self open, since its rule holds only as long as its inode is in use.
    if (::open("/proc/self", O_PATH | O_CLOEXEC) < 0) return false;
    const std::uint64_t read = reading | (rules.programs ? running : 0);
    for (const std::string& path : rules.readable) landlock.allow(path, read);
    for (const std::string& path : rules.writable)
        landlock.allow(path, read | writing | moving | truncating);
    for (const std::string& path : rules.written)
        landlock.allow(path, writing | moving | truncating);
    for (const char* device : {"/dev/null", "/dev/tty"}) landlock.allow(device, reading | writing);
    return landlock.enforce();
}

/// System calls that no renderer makes.
constexpr auto never_called = std::to_array({SCMP_SYS(ptrace),
                                             SCMP_SYS(process_vm_readv),
                                             SCMP_SYS(process_vm_writev),
                                             SCMP_SYS(mount),
                                             SCMP_SYS(umount2),
                                             SCMP_SYS(pivot_root),
                                             SCMP_SYS(chroot),
                                             SCMP_SYS(setns),
                                             SCMP_SYS(unshare),
                                             SCMP_SYS(bpf),
                                             SCMP_SYS(perf_event_open),
                                             SCMP_SYS(userfaultfd),
                                             SCMP_SYS(io_uring_setup),
                                             SCMP_SYS(kexec_load),
                                             SCMP_SYS(init_module),
                                             SCMP_SYS(finit_module),
                                             SCMP_SYS(delete_module),
                                             SCMP_SYS(add_key),
                                             SCMP_SYS(request_key),
                                             SCMP_SYS(keyctl),
                                             SCMP_SYS(reboot),
                                             SCMP_SYS(mknod),
                                             SCMP_SYS(mknodat),
                                             SCMP_SYS(setuid),
                                             SCMP_SYS(setgid)});
constexpr auto socket_calls =
    std::to_array({SCMP_SYS(socket), SCMP_SYS(connect), SCMP_SYS(bind), SCMP_SYS(listen),
                   SCMP_SYS(accept), SCMP_SYS(accept4)});
constexpr auto program_calls =
    std::to_array({SCMP_SYS(execve), SCMP_SYS(execveat), SCMP_SYS(fork), SCMP_SYS(vfork)});

bool confine_calls(const SandboxRules& rules) {
    const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
    if (!filter) return false;
    const auto forbid = [&](std::span<const int> calls) {
        for (const int call : calls) seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), call, 0);
    };
    forbid(never_called);
    if (!rules.sockets) forbid(socket_calls);
    if (!rules.programs) forbid(program_calls);
    seccomp_attr_set(filter, SCMP_FLTATR_CTL_TSYNC, 1);
    const bool loaded = seccomp_load(filter) == 0;
    seccomp_release(filter);
    return loaded;
}

std::string folder_around(const std::string& path) {
    const std::string folder = fs::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

/// Returns the libraries, fonts and status files of the system, and the files of the program.
std::vector<std::string> system_files(const std::string& library) {
    const std::string program = folder_around(own_path());
    return {"/usr",
            "/lib",
            "/lib64",
            "/etc/ld.so.cache",
            "/etc/localtime",
            "/etc/fonts",
            "/sys/devices/system",
            "/sys/fs/cgroup",
            "/proc/self",
            "/proc/cpuinfo",
            "/proc/meminfo",
            "/dev/urandom",
            program,
            program + "/../lib",
            library};
}

/// Adds what the scene may read. Files that lie directly in a folder are added one by one.
void add_scene_folders(SandboxRules& rules, const SceneFolders& folders) {
    rules.readable.insert(rules.readable.end(), folders.whole.begin(), folders.whole.end());
    for (const FolderFiles& each : folders.files) {
        // The preview reads a scene again, which its editor may have replaced by another file.
        if (rules.sockets && each.stem.empty()) rules.readable.push_back(each.folder);
        std::error_code failed;
        for (fs::directory_iterator entry(each.folder, failed), end; !failed && entry != end;
             entry.increment(failed)) {
            std::error_code none;
            if (each.has(entry->path().filename().string()) && entry->is_regular_file(none))
                rules.readable.push_back(entry->path().string());
        }
    }
}

/// Adds the folder of the picture. Files in a folder that is too wide are not readable because of
/// it, unless frames, films and pages read what the run itself makes.
void add_picture_folder(SandboxRules& rules, const Options& options, const std::string& picture) {
    const std::string folder = folder_around(picture);
    const auto real = path_without_links(folder);
    const bool wide = real && is_wide(*real);
    const bool reads_frames =
        options.animation.final_frame || options.animation.initial_frame || !options.page.empty();
    if (!wide || reads_frames) return rules.writable.push_back(folder);
    rules.written.push_back(folder);
    // What the scene has written it may read again.
    std::error_code none;
    Diagnostics said_elsewhere;
    const std::string own = own_folder(output_of(options, said_elsewhere), options);
    if (fs::is_symlink(own, none)) return;
    if (!fs::exists(own, none)) rules.made = own;
    rules.writable.push_back(own);
}

}  // namespace

SandboxRules sandbox_rules(const Options& options, const std::string& library) {
    SandboxRules rules;
    rules.sockets = options.preview_port.has_value();
    rules.programs = !options.movie.empty();
    rules.readable = system_files(library);
    Diagnostics said_elsewhere;
    const Output output = output_of(options, said_elsewhere);
    const bool makes_picture = options.task == Task::render || options.task == Task::export_mesh;
    const std::string scene = options.scene.value_or("-");
    add_scene_folders(rules, scene_folders(scene == "-" ? "" : folder_around(scene), output.path));
    if (scene != "-") rules.readable.insert(rules.readable.end(), {scene, scene + ".pov"});
    for (const auto* folders : {&options.libraries, &options.library_paths, &options.readable})
        rules.readable.insert(rules.readable.end(), folders->begin(), folders->end());
    if (rules.programs) rules.readable.push_back(folder_around(find_program("ffmpeg")));
    rules.writable = options.writable;
    if (makes_picture) add_picture_folder(rules, options, output.path);
    for (const std::string& file : {options.stats_file, options.depfile, options.mesh_file,
                                    options.readings_file, options.kept_lights, options.movie})
        if (!file.empty() && file != "-") rules.writable.push_back(folder_around(file));
    return rules;
}

SandboxRules sandbox_rules(const Options& options, const std::string& library,
                           std::span<const std::string> files) {
    SandboxRules rules;
    rules.readable = system_files(library);
    rules.readable.insert(rules.readable.end(), files.begin(), files.end());
    rules.programs = !options.movie.empty();
    if (rules.programs) {
        rules.readable.push_back(folder_around(find_program("ffmpeg")));
        rules.writable.push_back(folder_around(options.movie));
    }
    std::error_code none;
    const std::string& output = options.output;
    if (fs::is_directory(output, none)) {
        rules.writable.push_back(output);
    } else if (!output.empty()) {
        rules.writable.push_back(folder_around(output));
    } else {
        for (const std::string& file : files) rules.writable.push_back(folder_around(file));
    }
    return rules;
}

bool confine(const SandboxRules& rules) {
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return false;
    const bool files = confine_files(rules);
    return confine_calls(rules) && files;
}

bool confined(const Options& options, const SandboxRules& rules, const Console& console,
              Diagnostics& diagnostics) {
    const bool wanted = options.sandbox.value_or(!options.commands.any());
    if (!wanted || !console.confine) return true;
    std::error_code none;
    if (!rules.made.empty()) fs::create_directory(rules.made, none);
    if (console.confine(rules)) return true;
    if (!options.sandbox) {
        diagnostics.add(
            warning(
                Fault::option, {},
                "this system has no whole sandbox, Landlock and seccomp: only the program's own "
                "rules keep the scene from other files")
                .with_help("--sandbox off accepts this"));
        return true;
    }
    diagnostics.add(
        error(Fault::option, {}, "this system has no sandbox: Landlock or seccomp is missing")
            .with_help("--sandbox off"));
    return false;
}

}  // namespace candelabra
