// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/write_unv.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>

#include "core/errors.h"

namespace featuremesh {
namespace {

// Element descriptors of dataset 2412, the ones that FreeCAD's reader knows
constexpr int rod = 11, parabolic_beam = 24;
constexpr int thin_shell_triangle = 91, parabolic_thin_shell_triangle = 92;
constexpr int solid_tet = 111, parabolic_solid_tet = 118;
constexpr int node_entity = 7, element_entity = 8;

/// A text file in one large buffer.
class TextFile {
  public:
    explicit TextFile(const std::string& path) : path_(path), file_(std::fopen(path.c_str(), "wb"), &std::fclose) {
        if (!file_) throw Error("cannot write " + path + ": the folder is missing or write-protected");
        buffer_.resize(1 << 20);
        end_ = buffer_.data();
    }

    void text(std::string_view s) {
        reserve(s.size());
        std::memcpy(end_, s.data(), s.size());
        end_ += s.size();
    }
    /// Right-aligned in ten columns, more when the number needs them.
    void integer(std::int64_t value) {
        reserve(24);
        char digits[24];
        char* last = std::to_chars(digits, digits + sizeof digits, value).ptr;
        pad_to(10, last - digits);
        std::memcpy(end_, digits, static_cast<std::size_t>(last - digits));
        end_ += last - digits;
    }
    /// Seventeen digits in 25 columns.
    void real(double value) {
        reserve(40);
        char digits[32];
        char* last = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::scientific, 16).ptr;
        if (char* e = std::find(digits, last, 'e'); e != last) *e = 'E';
        pad_to(25, last - digits);
        std::memcpy(end_, digits, static_cast<std::size_t>(last - digits));
        end_ += last - digits;
    }
    void line_end() {
        reserve(1);
        *end_++ = '\n';
    }
    template <class... Values>
    void integers(Values... values) {
        (integer(static_cast<std::int64_t>(values)), ...);
        line_end();
    }
    void close() {
        flush();
        if (std::fclose(file_.release()) != 0) fail();
    }

  private:
    void pad_to(std::ptrdiff_t columns, std::ptrdiff_t used) {
        do *end_++ = ' ';
        while (++used < columns);
    }
    void reserve(std::size_t bytes) {
        if (static_cast<std::size_t>(buffer_.data() + buffer_.size() - end_) < bytes) flush();
        if (buffer_.size() < bytes) buffer_.resize(bytes), end_ = buffer_.data();
    }
    void flush() {
        const std::size_t used = static_cast<std::size_t>(end_ - buffer_.data());
        if (std::fwrite(buffer_.data(), 1, used, file_.get()) != used) fail();
        end_ = buffer_.data();
    }
    [[noreturn]] void fail() const {
        throw Error("cannot write " + path_ + ": the disk is full or the file was taken away");
    }

    std::string path_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    std::string buffer_;
    char* end_ = nullptr;
};

void begin_dataset(TextFile& file, int dataset) {
    file.text("    -1\n");
    char number[16];
    std::snprintf(number, sizeof number, "%6d\n", dataset);
    file.text(number);
}
void end_dataset(TextFile& file) { file.text("    -1\n"); }

void write_nodes(TextFile& file, const Mesh& mesh) {
    begin_dataset(file, 2411);
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        file.integers(mesh.node_numbers[i], 1, 1, 11);
        for (int k = 0; k < 3; ++k) file.real(mesh.points[i][k]);
        file.line_end();
    }
    end_dataset(file);
}

// The nodes of an element follow each other around it: corner, mid-side, corner
void write_segment(TextFile& file, const Mesh& mesh, std::size_t i) {
    const auto number = [&](NodeId n) { return mesh.node_numbers[n.index()]; };
    const auto& n = mesh.segments[i];
    file.integers(mesh.segment_numbers[i], mesh.order == 2 ? parabolic_beam : rod, 1, 1, 7, mesh.order == 2 ? 3 : 2);
    file.integers(0, 1, 1);
    if (mesh.order == 2)
        file.integers(number(n[0]), number(mesh.segment_mids[i]), number(n[1]));
    else
        file.integers(number(n[0]), number(n[1]));
}

void write_triangle(TextFile& file, const Mesh& mesh, std::size_t i) {
    const auto number = [&](NodeId n) { return mesh.node_numbers[n.index()]; };
    const auto& n = mesh.triangles[i];
    const bool second = mesh.order == 2;
    file.integers(mesh.triangle_numbers[i], second ? parabolic_thin_shell_triangle : thin_shell_triangle, 1, 1, 7,
                  second ? 6 : 3);
    if (second) {
        const auto& m = mesh.triangle_mids[i];
        file.integers(number(n[0]), number(m[0]), number(n[1]), number(m[1]), number(n[2]), number(m[2]));
    } else {
        file.integers(number(n[0]), number(n[1]), number(n[2]));
    }
}

void write_tet(TextFile& file, const Mesh& mesh, std::size_t i) {
    const auto number = [&](NodeId n) { return mesh.node_numbers[n.index()]; };
    const auto& n = mesh.tets[i];
    const bool second = mesh.order == 2;
    file.integers(mesh.tet_numbers[i], second ? parabolic_solid_tet : solid_tet, 1, 1, 7, second ? 10 : 4);
    if (second) {
        const auto& m = mesh.tet_mids[i];
        file.integers(number(n[0]), number(m[0]), number(n[1]), number(m[1]), number(n[2]), number(m[2]), number(m[3]),
                      number(m[4]));
        file.integers(number(m[5]), number(n[3]));
    } else {
        file.integers(number(n[0]), number(n[1]), number(n[2]), number(n[3]));
    }
}

void write_elements(TextFile& file, const Mesh& mesh) {
    begin_dataset(file, 2412);
    for (std::size_t i = 0; i < mesh.segments.size(); ++i) write_segment(file, mesh, i);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) write_triangle(file, mesh, i);
    for (std::size_t i = 0; i < mesh.tets.size(); ++i) write_tet(file, mesh, i);
    end_dataset(file);
}

void write_groups(TextFile& file, const std::vector<MeshGroup>& groups) {
    begin_dataset(file, 2467);
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const MeshGroup& group = groups[g];
        file.integers(g + 1, 0, 0, 0, 0, 0, 0, group.numbers.size());
        file.text(group.name);
        file.line_end();
        const int entity = group.kind == MeshGroup::Kind::node ? node_entity : element_entity;
        for (std::size_t i = 0; i < group.numbers.size(); ++i) {
            for (std::int64_t value : {std::int64_t{entity}, group.numbers[i], std::int64_t{0}, std::int64_t{0}})
                file.integer(value);
            if (i % 2 == 1 || i + 1 == group.numbers.size()) file.line_end();
        }
        if (group.numbers.empty()) file.line_end();
    }
    end_dataset(file);
}

}  // namespace

void write_unv(const Mesh& mesh, const std::vector<MeshGroup>& groups, const std::string& path) {
    TextFile file(path);
    write_nodes(file, mesh);
    write_elements(file, mesh);
    if (!groups.empty()) write_groups(file, groups);
    file.close();
}

}  // namespace featuremesh
