// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/isolated_run.h"

#ifndef _WIN32
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <ctime>
#include <new>
#include <string>
#include <thread>

#include "core/errors.h"
#include "core/messages.h"
#endif
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace featuremesh {

namespace {
using Work = std::function<std::vector<std::byte>(const RunContext&)>;
}

#ifndef _WIN32

namespace {

/// The last byte of what is written, so that nothing depends on whether the program waits for children of its own.
constexpr std::byte complete{42};

/// How the copy ends where it has no bytes to give.
constexpr int has_failed = 1, has_no_memory = 2;
constexpr std::array crashes{SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL};

/// Ends the process.
[[noreturn]] void work_and_write(const Work& work, int out) {
    try {
        std::vector<std::byte> bytes = work(RunContext());
        bytes.push_back(complete);
        for (std::size_t done = 0; done < bytes.size();) {
            const ssize_t count = write(out, bytes.data() + done, bytes.size() - done);
            if (count < 0 && errno == EINTR) continue;
            if (count <= 0) _exit(has_failed);
            done += static_cast<std::size_t>(count);
        }
        _exit(0);
    } catch (const std::bad_alloc&) {
        _exit(has_no_memory);
    } catch (...) {
        _exit(has_failed);
    }
}

/// A library in trouble tells the terminal of it, and writes files into the folder in which the user happens to be.
/// In /proc nobody can make one.
void leave_no_traces_but(int out) {
    const int nowhere = open("/dev/null", O_WRONLY);
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
        if (nowhere >= 0 && stream != out) dup2(nowhere, stream);
    if (chdir("/proc") != 0 && chdir("/") != 0) _exit(has_failed);
}

/// In the copy: nothing of it reaches the caller but what is written to `out`.
[[noreturn]] void work_and_end(const Work& work, const Patience& patience, int out) {
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    // a crash is no news for the handlers of the program
    for (const int signal : crashes) std::signal(signal, SIG_DFL);
    std::signal(SIGXCPU, SIG_DFL);
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    const rlimit seconds{patience.processor_seconds, patience.processor_seconds + 1};
    setrlimit(RLIMIT_CPU, &seconds);
    leave_no_traces_but(out);
    try {
        // On a thread of its own it gets memory of its own. What the program has freed lies in pages that the two
        // share, and each would be copied for a few bytes of it.
        std::thread([&] { work_and_write(work, out); }).join();
    } catch (...) {
        work_and_write(work, out);
    }
    _exit(has_failed);
}

/// Throws where it is not the work's own fault that a copy with this status gave nothing.
void refuse_end_from_outside(int status) {
    if (WIFEXITED(status) && WEXITSTATUS(status) == has_no_memory) throw std::bad_alloc();
    if (!WIFSIGNALED(status)) return;
    const int signal = WTERMSIG(status);
    if (signal == SIGXCPU) throw MeshError(say<Code::step_does_not_end>());
    if (std::find(crashes.begin(), crashes.end(), signal) == crashes.end())
        throw MeshError(say<Code::step_was_ended>());
}

class Child {
  public:
    Child(pid_t process, int in) : process_(process), in_(in) {}
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        close(in_);
        end();
    }

    /// All that it writes; none when that is not complete.
    std::optional<std::vector<std::byte>> read_all(const Patience& patience, const RunContext& context) {
        constexpr int milliseconds = 50;
        const unsigned most_idle_rounds = patience.idle_seconds * 1000 / milliseconds;
        std::vector<std::byte> bytes;
        std::array<std::byte, 1 << 16> part;
        for (unsigned idle_rounds = 0;; ++idle_rounds) {
            context.check_cancelled();
            pollfd ready{in_, POLLIN, 0};
            if (poll(&ready, 1, milliseconds) <= 0) {
                if (is_at_work()) idle_rounds = 0;
                if (idle_rounds < most_idle_rounds) continue;
                throw MeshError(say<Code::step_does_not_end>());
            }
            const ssize_t count = read(in_, part.data(), part.size());
            if (count < 0 && errno == EINTR) continue;
            if (count < 0) return {};
            if (count == 0) break;
            bytes.insert(bytes.end(), part.begin(), part.begin() + count);
        }
        if (bytes.empty() || bytes.back() != complete) {
            refuse_end_from_outside(end());
            return {};
        }
        bytes.pop_back();
        return bytes;
    }

  private:
    /// Its last status, which killing does not change once it has ended; 0 where the program itself waits for children.
    int end() {
        if (process_ <= 0) return 0;
        int status = 0;
        kill(process_, SIGKILL);
        while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
        }
        process_ = 0;
        return status;
    }

    /// Has it used the processor since this was true last? A thread that only wakes to look at a clock is not at work.
    bool is_at_work() {
        constexpr std::chrono::milliseconds least{5};
        clockid_t clock = 0;
        timespec now{};
        if (clock_getcpuclockid(process_, &clock) != 0 || clock_gettime(clock, &now) != 0) return false;
        const auto used = std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec);
        if (used < used_ + least) return false;
        used_ = used;
        return true;
    }

    pid_t process_;
    int in_;
    std::chrono::nanoseconds used_{};
};

}  // namespace

std::optional<std::vector<std::byte>> run_isolated(const Work& work, const Patience& patience,
                                                   const RunContext& context) {
    std::array<int, 2> ends;
    if (pipe(ends.data()) != 0) return work(context);
    for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);  // other processes of the program do not hold it open
    const pid_t process = fork();
    if (process == 0) {
        close(ends[0]);
        work_and_end(work, patience, ends[1]);
    }
    close(ends[1]);
    Child child(process, ends[0]);
    if (process < 0) return work(context);
    return child.read_all(patience, context);
}

#else

std::optional<std::vector<std::byte>> run_isolated(const Work& work, const Patience&, const RunContext& context) {
    return work(context);
}

#endif

}  // namespace featuremesh
