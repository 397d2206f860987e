// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/recovery/tetgen.h"

#ifndef _WIN32
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/isolated_run.h"
#include "volume/tets/orientation.h"
#include "volume/tets/tet_complex.h"
#endif

namespace featuremesh {

#ifndef _WIN32

namespace {

namespace fs = std::filesystem;
using Tet = std::array<int, 4>;

/// Its path; empty where it is not installed.
std::string program() {
    const char* path = std::getenv("PATH");
    std::string rest = path ? path : "";
    for (std::size_t end = 0; !rest.empty(); rest.erase(0, std::min(end, rest.size() - 1) + 1)) {
        end = rest.find(':');
        const std::string found = rest.substr(0, end) + "/tetgen";
        if (access(found.c_str(), X_OK) == 0) return found;
    }
    return {};
}

class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::error_code error;
        std::string pattern = (fs::temp_directory_path(error) / "featuremesh-XXXXXX").string();
        if (!error && mkdtemp(pattern.data())) path_ = pattern;
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder() {
        std::error_code ignored;
        if (!path_.empty()) fs::remove_all(path_, ignored);
    }
    bool exists() const { return !path_.empty(); }
    std::string file(const char* name) const { return (path_ / name).string(); }

  private:
    fs::path path_;
};

void write_input(const std::string& file, const Cavity& cavity, std::span<const Vec3> seeds) {
    std::ofstream out(file);
    out.precision(std::numeric_limits<double>::max_digits10);
    out << cavity.points.size() + seeds.size() << " 3 0 0\n";
    std::size_t number = 0;
    for (const std::span<const Vec3> points : {std::span<const Vec3>(cavity.points), seeds})
        for (const Vec3& p : points) out << number++ << ' ' << p.x << ' ' << p.y << ' ' << p.z << '\n';
    out << cavity.facets.size() << " 0\n";
    for (const Facet& facet : cavity.facets)
        out << "3 " << facet.corners[0] << ' ' << facet.corners[1] << ' ' << facet.corners[2] << '\n';
    out << "0\n0\n";
    if (!out.flush()) throw std::runtime_error("disk full");
}

/// In the copy of the process that waits for it, and ends as it did where something ended it.
void run_and_wait(const std::string& path, const std::string& input) {
    const pid_t process = fork();
    if (process == 0) {
#ifdef __linux__
        prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
        // tets of a piecewise linear complex, whose facets stay as they are; of the convex hull; quietly
        execl(path.c_str(), "tetgen", "-pYcQF", input.c_str(), static_cast<char*>(nullptr));
        _exit(127);
    }
    int status = 0;
    while (waitpid(process, &status, 0) < 0)
        if (errno != EINTR) throw std::runtime_error("no such process");
    if (WIFSIGNALED(status)) raise(WTERMSIG(status));
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw std::runtime_error("TetGen failed");
}

struct Answer {
    std::vector<Vec3> added;
    std::vector<Tet> tets;
};

Answer read_answer(const std::string& nodes, const std::string& tets, std::size_t given) {
    Answer answer;
    std::ifstream in(nodes);
    std::size_t count = 0, number = 0;
    int dimension = 0, attributes = 0, marks = 0;
    in >> count >> dimension >> attributes >> marks;
    for (std::size_t i = 0; i < count && in; ++i) {
        Vec3 p;
        in >> number >> p.x >> p.y >> p.z;
        if (i >= given) answer.added.push_back(p);
    }
    std::ifstream of_tets(tets);
    int corners = 0;
    std::size_t tet_count = 0;
    of_tets >> tet_count >> corners >> attributes;
    double attribute = 0;
    for (std::size_t i = 0; i < tet_count && of_tets; ++i) {
        Tet& tet = answer.tets.emplace_back();
        of_tets >> number >> tet[0] >> tet[1] >> tet[2] >> tet[3];
        for (int k = 0; k < attributes; ++k) of_tets >> attribute;
    }
    const auto is_point = [&](int c) { return c >= 0 && static_cast<std::size_t>(c) < count; };
    if (!in || !of_tets || corners != 4 || count < given ||
        !std::all_of(answer.tets.begin(), answer.tets.end(),
                     [&](const Tet& tet) { return std::all_of(tet.begin(), tet.end(), is_point); }))
        throw std::runtime_error("TetGen's answer is not complete");
    return answer;
}

std::vector<std::byte> bytes_of(const Answer& answer) {
    const std::size_t count = answer.added.size(), of_points = count * sizeof(Vec3),
                      of_tets = answer.tets.size() * sizeof(Tet);
    std::vector<std::byte> bytes(sizeof count + of_points + of_tets);
    std::memcpy(bytes.data(), &count, sizeof count);
    if (of_points > 0) std::memcpy(bytes.data() + sizeof count, answer.added.data(), of_points);
    if (of_tets > 0) std::memcpy(bytes.data() + sizeof count + of_points, answer.tets.data(), of_tets);
    return bytes;
}

Answer answer_of(const std::vector<std::byte>& bytes) {
    Answer answer;
    std::size_t count = 0;
    std::memcpy(&count, bytes.data(), sizeof count);
    const std::size_t of_points = count * sizeof(Vec3), of_tets = bytes.size() - sizeof count - of_points;
    answer.added.resize(count), answer.tets.resize(of_tets / sizeof(Tet));
    if (of_points > 0) std::memcpy(answer.added.data(), bytes.data() + sizeof count, of_points);
    if (of_tets > 0) std::memcpy(answer.tets.data(), bytes.data() + sizeof count + of_points, of_tets);
    return answer;
}

/// With tets inside regions only, and points that these have. None where a tet there has no volume.
std::optional<CavityFill> inside_regions(const Cavity& cavity, const CavityFill& whole, std::size_t given) {
    std::vector<char> is_used(whole.points.size(), 0);
    std::fill_n(is_used.begin(), cavity.points.size(), 1);
    TetComplex complex;
    std::vector<int> regions;
    for (std::size_t t = 0; t < whole.regions.size(); ++t) {
        if (whole.regions[t] < 0) continue;
        const Tet& tet = whole.triangulation.tets[t];
        const auto& p = whole.points;
        if (orientation(p[tet[0]], p[tet[1]], p[tet[2]], p[tet[3]]) <= 0) return {};
        for (const int c : tet) is_used[c] = 1;
        complex.tets.push_back(tet), regions.push_back(whole.regions[t]);
    }
    CavityFill fill;
    fill.relocated.emplace();
    std::vector<int> number(is_used.size(), -1);
    for (std::size_t i = 0; i < is_used.size(); ++i) {
        if (!is_used[i]) continue;
        number[i] = static_cast<int>(fill.points.size());
        if (i >= given) fill.relocated->push_back(number[i]);
        fill.points.push_back(whole.points[i]);
    }
    for (Tet& tet : complex.tets)
        for (int& c : tet) c = number[c];
    complex.points = fill.points;
    connect(complex);
    fill.triangulation = {std::move(complex.tets), std::move(complex.neighbours)};
    fill.places = find_facets(fill.triangulation, fill.points.size(), cavity.facets);
    fill.regions = std::move(regions);
    return fill.is_complete() ? std::optional(std::move(fill)) : std::nullopt;
}

}  // namespace

std::optional<CavityFill> recover_by_tetgen(const Cavity& cavity, std::span<const Vec3> seeds, RunContext& context) {
    const std::string path = program();
    if (path.empty()) return {};
    const TemporaryFolder folder;
    if (!folder.exists()) return {};
    const std::size_t given = cavity.points.size() + seeds.size();
    constexpr unsigned least_seconds = 60, points_per_second = 200;
    const auto bytes = run_isolated(
        [&](const RunContext&) {
            const std::string input = folder.file("cavity.smesh");
            write_input(input, cavity, seeds);
            run_and_wait(path, input);
            return bytes_of(read_answer(folder.file("cavity.1.node"), folder.file("cavity.1.ele"), given));
        },
        {least_seconds + static_cast<unsigned>(given / points_per_second)}, context);
    if (!bytes) return {};
    Answer answer = answer_of(*bytes);
    std::vector<Vec3> points = cavity.points;
    points.insert(points.end(), seeds.begin(), seeds.end());
    points.insert(points.end(), answer.added.begin(), answer.added.end());
    TetComplex complex;
    complex.points = points;
    for (Tet& tet : answer.tets)
        if (orientation(points[tet[0]], points[tet[1]], points[tet[2]], points[tet[3]]) < 0) std::swap(tet[2], tet[3]);
    complex.tets = std::move(answer.tets);
    connect(complex);
    const CavityFill whole =
        label_cavity(cavity, std::move(points), {std::move(complex.tets), std::move(complex.neighbours)}, context);
    return whole.is_complete() ? inside_regions(cavity, whole, given) : std::nullopt;
}

#else

std::optional<CavityFill> recover_by_tetgen(const Cavity&, std::span<const Vec3>, RunContext&) { return {}; }

#endif

}  // namespace featuremesh
