// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh is made without cells: what it is told about features and faces is what the cells would say.
#include <BRepFilletAPI_MakeFillet.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <random>

#include "catch.h"
#include "difference/face_owners.h"
#include "part_documents.h"
#include "update/part_mesh.h"

using namespace featuremesh;

namespace {

struct Round {
    std::string name;
    bool is_hole;
    double x, y, radius, height;
};

/// A plate with bosses and holes, one after the other.
RawDocument document_of(const std::vector<Round>& rounds) {
    PartDocument document = PartDocument().box("Plate", {0, 0, 0}, {100, 100, 8});
    std::string base = "Plate";
    for (const Round& r : rounds) {
        const std::string result = r.name + "Result";
        if (r.is_hole)
            document.cylinder(r.name, {r.x, r.y, -1}, r.radius, 10).cut(result, base, r.name);
        else
            document.cylinder(r.name, {r.x, r.y, 8}, r.radius, r.height).fuse(result, base, r.name);
        base = result;
    }
    return document.finish();
}

class RandomEdits {
  public:
    explicit RandomEdits(unsigned seed) : random_(seed) {
        for (int i = 0; i < 16; ++i) rounds.push_back(some(i));
    }

    void edit() {
        Round& r = rounds[std::size_t(between(0, double(rounds.size()) - 0.01))];
        switch (int(between(0, 4.99))) {
            case 0:
                r.x += between(-4, 4);
                break;
            case 1:
                r.radius = between(1.5, 5);
                break;
            case 2:
                r.height += 1;
                break;
            case 3:
                rounds.push_back(some(next_++));
                break;
            default:
                rounds.erase(rounds.begin() + (&r - rounds.data()));
                break;
        }
    }

    std::vector<Round> rounds;

  private:
    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    Round some(int number) {
        return {"Round" + std::to_string(number),
                between(0, 1) < 0.5,
                between(8, 92),
                between(8, 92),
                between(1.5, 5),
                between(4, 10)};
    }
    std::mt19937 random_;
    int next_ = 100;
};

using FacesOfFeature = std::vector<std::pair<std::string, std::vector<FaceId>>>;

FacesOfFeature new_faces(const FeatureDifference& difference) {
    FacesOfFeature faces;
    for (const FeatureChange& change : difference.features)
        faces.emplace_back(change.name + to_string(change.verdict), change.new_faces);
    return faces;
}

}  // namespace

TEST_CASE("after random edits volumes, owners and verdicts are those of the cells") {
    const unsigned seed = GENERATE(1u, 2u);
    INFO("seed " << seed);
    RandomEdits edits(seed);
    RunContext context;
    PartState before = read_part_to_mesh(document_of(edits.rounds), context),
              before_with_cells = read_part(document_of(edits.rounds), context);
    for (int round = 0; round < 8; ++round) {
        edits.edit();
        const RawDocument document = document_of(edits.rounds);
        PartState now = read_part_to_mesh(document, context, &before), with_cells = read_part(document, context);
        CHECK(now.cells.cells.empty());
        REQUIRE(now.cells.feature_volumes.size() == with_cells.cells.feature_volumes.size());
        for (std::size_t f = 0; f < now.cells.feature_volumes.size(); ++f)
            CHECK(now.cells.feature_volumes[f] ==
                  Approx(with_cells.cells.feature_volumes[f]).epsilon(1e-7).margin(1e-6));
        CHECK(now.cells.report.untrusted == with_cells.cells.report.untrusted);
        CHECK(owners_of_faces(now) == with_cells.cells.owners_of_final_face);
        CHECK(new_faces(compare(before, now, 2.0, context)) ==
              new_faces(compare(before_with_cells, with_cells, 2.0, context)));
        before = std::move(now);
        before_with_cells = std::move(with_cells);
    }
}

TEST_CASE("features that were reordered, or that failed, are told apart without cells") {
    RandomEdits edits(5);
    RunContext context;
    const PartState before = read_part_to_mesh(document_of(edits.rounds), context);
    std::swap(edits.rounds[2], edits.rounds[9]);
    const PartState reordered = read_part_to_mesh(document_of(edits.rounds), context, &before);
    CHECK(owners_of_faces(reordered) == read_part(document_of(edits.rounds), context).cells.owners_of_final_face);
    RawDocument failed = document_of(RandomEdits(5).rounds);
    failed.records[4].error = "it failed";
    const PartState in_error = read_part_to_mesh(failed, context, &before);
    CHECK(in_error.cells.report.untrusted == read_part(failed, context).cells.report.untrusted);
}

TEST_CASE("no mesh waits for cells") {
    std::vector<std::string> steps;
    RunContext context;
    context.on_progress = [&](std::string_view step, double) {
        steps.emplace_back(step);
        return true;
    };
    RandomEdits edits(6);
    MeshOptions options;
    options.sizing.size = 6;
    const PartMeshResult made = mesh_part(document_of(edits.rounds), options, context);
    edits.rounds[3].radius += 1;
    const PartMeshResult updated = update_part(*made.part_mesh, document_of(edits.rounds), options, context);
    CHECK(std::count(steps.begin(), steps.end(), "cells") == 0);
    CHECK(std::count(steps.begin(), steps.end(), "difference") > 0);
    CHECK(updated.report.fallbacks.empty());
    const PartState with_cells = read_part(document_of(edits.rounds), context);
    CHECK(std::count(steps.begin(), steps.end(), "cells") > 0);
    CHECK(owners_of_faces(updated.part_mesh->part) == owners_of_faces(with_cells));
}

TEST_CASE("what a feature did in one document is not looked for again in another") {
    PartDocument document = PartDocument().box("Block", {0, 0, 0}, {20, 10, 10});
    BRepFilletAPI_MakeFillet rounding(document.shape("Block"));
    rounding.Add(2, TopoDS::Edge(TopExp_Explorer(document.shape("Block"), TopAbs_EDGE).Current()));
    document.add("Rounding", "Part::Fillet", rounding.Shape(), {{"Base", "Block", ""}});
    RunContext context;
    const PartState one = read_part(document.finish(), context);
    const auto removed_by = [](const PartState& state) {
        return state.tree[*state.tree.find("Rounding")].volumes.at(0).shape;
    };
    CHECK(removed_by(read_part(document.finish(), context, &one.tree)).IsSame(removed_by(one)));
    CHECK(removed_by(read_part_to_mesh(document.finish(), context, &one)).IsSame(removed_by(one)));
    CHECK_FALSE(removed_by(read_part(document.finish(), context)).IsSame(removed_by(one)));
}
