// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/confine.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
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

}  // namespace

bool confine(const SandboxRules& rules) {
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return false;
    const bool files = confine_files(rules);
    return confine_calls(rules) && files;
}

}  // namespace candelabra
