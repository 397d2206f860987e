// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "box_mesh.h"
#include "catch.h"
#include "core/errors.h"
#include "mesh/write_unv.h"

using namespace featuremesh;

namespace {

struct UnvElement {
    int descriptor = 0;
    std::vector<Number> nodes;
};

/// What a reader that goes by white space finds, as FreeCAD's does.
struct UnvContent {
    std::map<Number, Vec3> nodes;
    std::map<Number, UnvElement> elements;
    std::map<std::string, std::vector<std::pair<int, Number>>> groups;
    std::size_t longest_line = 0;
};

UnvContent read_unv(const std::string& path) {
    UnvContent content;
    std::ifstream file(path);
    std::string line;
    std::stringstream text;
    while (std::getline(file, line)) {
        content.longest_line = std::max(content.longest_line, line.size());
        text << line << '\n';
    }
    int mark = 0, dataset = 0;
    while (text >> mark >> dataset) {
        REQUIRE(mark == -1);
        Number label = 0;
        while (text >> label && label != -1) {
            if (dataset == 2411) {
                int system, color, other;
                Vec3 p;
                text >> other >> system >> color >> p.x >> p.y >> p.z;
                content.nodes[label] = p;
            } else if (dataset == 2412) {
                UnvElement element;
                int physical, material, color, count;
                text >> element.descriptor >> physical >> material >> color >> count;
                if (element.descriptor < 30)
                    for (int i = 0; i < 3; ++i) text >> physical;
                element.nodes.resize(static_cast<std::size_t>(count));
                for (Number& n : element.nodes) text >> n;
                content.elements[label] = element;
            } else {
                REQUIRE(dataset == 2467);
                int ignored, count = 0;
                for (int i = 0; i < 6; ++i) text >> ignored;
                text >> count >> std::ws;
                std::string name;
                std::getline(text, name);
                auto& group = content.groups[name];
                for (int i = 0; i < count; ++i) {
                    int type;
                    Number number;
                    text >> type >> number >> ignored >> ignored;
                    group.emplace_back(type, number);
                }
            }
        }
    }
    return content;
}

std::string temporary(const std::string& name) { return (std::filesystem::temp_directory_path() / name).string(); }

}  // namespace

TEST_CASE("a UNV file holds every bit, number and group of the mesh") {
    Mesh mesh = box_mesh(2);
    for (Vec3& p : mesh.points) p = p * (1.0 / 3) + Vec3{1e-7, -123456.789, 0};
    for (Number& number : mesh.node_numbers) number = 3 * number + 100;
    const std::string path = temporary("featuremesh_test_1.unv");
    write_unv(mesh,
              {{"Face1_Nodes", MeshGroup::Kind::node, {103, 106, 109}},
               {"Solid1", MeshGroup::Kind::volume, mesh.tet_numbers},
               {"None", MeshGroup::Kind::face, {}}},
              path);
    const UnvContent content = read_unv(path);
    std::remove(path.c_str());
    CHECK(content.longest_line <= 80);
    REQUIRE(content.nodes.size() == mesh.points.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
        CHECK(content.nodes.at(mesh.node_numbers[i]) == mesh.points[i]);
    REQUIRE(content.elements.size() == mesh.segments.size() + mesh.triangles.size() + mesh.tets.size());
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        const UnvElement& element = content.elements.at(mesh.tet_numbers[t]);
        CHECK(element.descriptor == 111);
        for (std::size_t i = 0; i < 4; ++i) CHECK(element.nodes.at(i) == mesh.node_numbers[mesh.tets[t][i].index()]);
    }
    CHECK(content.groups.at("Face1_Nodes") == std::vector<std::pair<int, Number>>{{7, 103}, {7, 106}, {7, 109}});
    CHECK(content.groups.at("Solid1").size() == mesh.tets.size());
    CHECK(content.groups.at("Solid1")[0] == std::pair<int, Number>{8, mesh.tet_numbers[0]});
    CHECK(content.groups.at("None").empty());
}

TEST_CASE("a 10-node UNV file goes around each element, corner and mid-side in turn") {
    Mesh mesh = box_mesh(1);
    add_mid_side_nodes(mesh);
    const std::string path = temporary("featuremesh_test_2.unv");
    write_unv(mesh, {}, path);
    const UnvContent content = read_unv(path);
    std::remove(path.c_str());
    const auto middle = [&](Number a, Number b) { return (content.nodes.at(a) + content.nodes.at(b)) * 0.5; };
    for (const auto& [number, element] : content.elements) {
        const auto& n = element.nodes;
        if (element.descriptor == 24) {
            CHECK(content.nodes.at(n[1]) == middle(n[0], n[2]));
        } else if (element.descriptor == 92) {
            for (std::size_t s = 0; s < 6; s += 2) CHECK(content.nodes.at(n[s + 1]) == middle(n[s], n[(s + 2) % 6]));
        } else {
            REQUIRE(element.descriptor == 118);
            for (std::size_t s = 0; s < 6; s += 2) CHECK(content.nodes.at(n[s + 1]) == middle(n[s], n[(s + 2) % 6]));
            for (std::size_t s = 0; s < 3; ++s) CHECK(content.nodes.at(n[6 + s]) == middle(n[2 * s], n[9]));
        }
    }
}

TEST_CASE("a file that cannot be written is an error that names it") {
    CHECK_THROWS_AS(write_unv(box_mesh(1), {}, "/nonexistent/folder/mesh.unv"), Error);
    if (std::filesystem::exists("/dev/full")) CHECK_THROWS_AS(write_unv(box_mesh(4), {}, "/dev/full"), Error);
}
