// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/isolated_run.h"

#if __has_include(<unistd.h>)
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#endif
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace featuremesh {

namespace {
using Work = std::function<std::vector<std::byte>(const RunContext&)>;
}

#if __has_include(<unistd.h>)

namespace {

/// The last byte of what is written, so that nothing depends on whether the program waits for children of its own.
constexpr std::byte complete{42};

/// In the copy: nothing of it reaches the caller but what is written to `out`.
[[noreturn]] void work_and_end(const Work& work, int out) {
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    // a crash is no news for the handlers of the program
    for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL}) std::signal(signal, SIG_DFL);
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    try {
        std::vector<std::byte> bytes = work(RunContext());
        bytes.push_back(complete);
        for (std::size_t done = 0; done < bytes.size();) {
            const ssize_t count = write(out, bytes.data() + done, bytes.size() - done);
            if (count < 0 && errno == EINTR) continue;
            if (count <= 0) _exit(1);
            done += static_cast<std::size_t>(count);
        }
        _exit(0);
    } catch (...) {
        _exit(1);
    }
}

class Child {
  public:
    Child(pid_t process, int in) : process_(process), in_(in) {}
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        close(in_);
        if (process_ <= 0) return;
        kill(process_, SIGKILL);  // no matter when it has ended already
        while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }

    /// All that it writes; none when that is not complete.
    std::optional<std::vector<std::byte>> read_all(const RunContext& context) {
        constexpr int milliseconds = 50;
        std::vector<std::byte> bytes;
        std::array<std::byte, 1 << 16> part;
        for (;;) {
            context.check_cancelled();
            pollfd ready{in_, POLLIN, 0};
            if (poll(&ready, 1, milliseconds) <= 0) continue;
            const ssize_t count = read(in_, part.data(), part.size());
            if (count < 0 && errno == EINTR) continue;
            if (count < 0) return {};
            if (count == 0) break;
            bytes.insert(bytes.end(), part.begin(), part.begin() + count);
        }
        if (bytes.empty() || bytes.back() != complete) return {};
        bytes.pop_back();
        return bytes;
    }

  private:
    pid_t process_;
    int in_;
};

}  // namespace

std::optional<std::vector<std::byte>> run_isolated(const Work& work, const RunContext& context) {
    std::array<int, 2> ends;
    if (pipe(ends.data()) != 0) return work(context);
    for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);  // other processes of the program do not hold it open
    const pid_t process = fork();
    if (process == 0) {
        close(ends[0]);
        work_and_end(work, ends[1]);
    }
    close(ends[1]);
    Child child(process, ends[0]);
    if (process < 0) return work(context);
    return child.read_all(context);
}

#else

std::optional<std::vector<std::byte>> run_isolated(const Work& work, const RunContext& context) {
    return work(context);
}

#endif

}  // namespace featuremesh
