// SPDX-License-Identifier: GPL-3.0-or-later
// Reading after an edit, with the state before it at hand, says what reading from nothing says.
#include <BRepFilletAPI_MakeFillet.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <random>

#include "catch.h"
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

PartState with_fallback(PartState state) {
    state.cells.report.fallbacks.push_back("nothing is fused after this");
    return state;
}

void check_same_books(const PartState& one, const PartState& other) {
    REQUIRE(one.cells.feature_volumes.size() == other.cells.feature_volumes.size());
    for (std::size_t f = 0; f < one.cells.feature_volumes.size(); ++f)
        CHECK(one.cells.feature_volumes[f] == Approx(other.cells.feature_volumes[f]).epsilon(1e-7).margin(1e-6));
    CHECK(one.cells.report.material_volume == Approx(other.cells.report.material_volume).epsilon(1e-8));
    CHECK(one.cells.report.final_volume == Approx(other.cells.report.final_volume).epsilon(1e-12));
    CHECK(one.cells.report.untrusted == other.cells.report.untrusted);
    CHECK(one.cells.report.fallbacks == other.cells.report.fallbacks);
}

}  // namespace

TEST_CASE("after random edits cells and owners are those from nothing") {
    const unsigned seed = GENERATE(1u, 2u);
    INFO("seed " << seed);
    RandomEdits edits(seed);
    RunContext context;
    PartState before = read_part(document_of(edits.rounds), context);
    int summaries = 0;
    for (int round = 0; round < 8; ++round) {
        edits.edit();
        const RawDocument document = document_of(edits.rounds);
        PartState live = read_part_to_mesh(document, context, &before);
        const PartState fresh = read_part(document, context);
        summaries += live.cells.is_summary;
        check_same_books(live, fresh);
        const FeatureDifference difference = compare(before, live, 2.0, context);
        CHECK(difference.owners_of_new_face == fresh.cells.owners_of_final_face);
        const PartState doubted = with_fallback(before), unfused = read_part_to_mesh(document, context, &doubted);
        CHECK(unfused.cells.owners_of_final_face.empty());
        check_same_books(unfused, fresh);
        CHECK(compare(before, unfused, 2.0, context).owners_of_new_face == fresh.cells.owners_of_final_face);
        live.cells.owners_of_final_face = difference.owners_of_new_face;
        before = std::move(live);
    }
    CHECK(summaries >= 4);
}

TEST_CASE("the mesh does not know how the cells were had") {
    RandomEdits edits(7);
    MeshOptions options;
    options.sizing.size = 6;
    RunContext context;
    const auto old = mesh_part(document_of(edits.rounds), options, context).part_mesh;
    PartMesh unfused = *old, untold = *old;
    unfused.part = with_fallback(unfused.part);
    untold.part.cells.report.material_volume += 1;
    edits.rounds[3].radius += 1;
    const auto one = update_part(*old, document_of(edits.rounds), options, context).part_mesh;
    CHECK(one->part.cells.is_summary);
    const auto two = update_part(unfused, document_of(edits.rounds), options, context).part_mesh;
    CHECK(two->part.cells.is_summary);
    const auto three = update_part(untold, document_of(edits.rounds), options, context).part_mesh;
    CHECK_FALSE(three->part.cells.is_summary);
    for (const auto& other : {two, three}) {
        CHECK(one->mesh.points == other->mesh.points);
        CHECK(one->mesh.tets == other->mesh.tets);
        CHECK(one->mesh.node_numbers == other->mesh.node_numbers);
        CHECK(one->part.cells.owners_of_final_face == other->part.cells.owners_of_final_face);
    }
}

TEST_CASE("a feature added to a chain or taken out of it is fused without the rest of the part") {
    RandomEdits edits(9);
    RunContext context;
    const auto all = edits.rounds;
    for (const std::ptrdiff_t at : {0, 7, 15}) {
        auto fewer = all;
        fewer.erase(fewer.begin() + at);
        const PartState whole = read_part(document_of(all), context), part = read_part(document_of(fewer), context);
        const PartState added = read_part_to_mesh(document_of(all), context, &part),
                        removed = read_part_to_mesh(document_of(fewer), context, &whole);
        CHECK(added.cells.is_summary);
        CHECK(removed.cells.is_summary);
        check_same_books(added, whole);
        check_same_books(removed, part);
        CHECK(compare(part, added, 2.0, context).owners_of_new_face == whole.cells.owners_of_final_face);
        CHECK(compare(whole, removed, 2.0, context).owners_of_new_face == part.cells.owners_of_final_face);
    }
}

TEST_CASE("features that were reordered, or that failed, are read without a fuse") {
    RandomEdits edits(5);
    RunContext context;
    const PartState before = read_part(document_of(edits.rounds), context);
    std::swap(edits.rounds[2], edits.rounds[9]);
    const PartState reordered = read_part_to_mesh(document_of(edits.rounds), context, &before);
    CHECK(reordered.cells.owners_of_final_face.empty());
    CHECK(compare(before, reordered, 2.0, context).owners_of_new_face ==
          read_part(document_of(edits.rounds), context).cells.owners_of_final_face);
    RawDocument failed = document_of(RandomEdits(5).rounds);
    failed.records[4].error = "it failed";
    const PartState in_error = read_part_to_mesh(failed, context, &before);
    CHECK(in_error.cells.owners_of_final_face.empty());
    CHECK(in_error.cells.report.untrusted == read_part(failed, context).cells.report.untrusted);
}

TEST_CASE("nobody waits for cells to get a mesh") {
    const RawDocument document = document_of(RandomEdits(6).rounds);
    RunContext context;
    const PartState whole = read_part(document, context), hurried = read_part_to_mesh(document, context, nullptr, 0),
                    unfused = read_part_unfused(document, context);
    CHECK(read_part_to_mesh(document, context).cells.report.fallbacks.empty());
    REQUIRE(hurried.cells.report.fallbacks.size() == 1);
    CHECK(hurried.cells.report.fallbacks[0].find("too long") != std::string::npos);
    CHECK(unfused.cells.report.fallbacks.empty());
    for (const PartState* state : {&hurried, &unfused}) {
        CHECK(state->cells.cells.empty());
        CHECK(state->cells.owners_of_final_face == whole.cells.owners_of_final_face);
        CHECK(state->cells.report.untrusted.empty());
    }
}

TEST_CASE("cells are looked for when the mesh is there, and have its time") {
    std::vector<std::string> steps;
    RunContext context;
    context.on_progress = [&](std::string_view step, double) {
        if (steps.empty() || steps.back() != step) steps.emplace_back(step);
        return true;
    };
    const RawDocument document = document_of(RandomEdits(6).rounds);
    MeshOptions options;
    options.sizing.size = 4;
    const PartMeshResult result = mesh_part(document, options, context);
    const auto at = [&](const char* step) { return std::find(steps.begin(), steps.end(), step) - steps.begin(); };
    CHECK(at("volume") < at("cells"));
    CHECK(at("cells") < std::ssize(steps));
    CHECK(result.part_mesh->part.cells.cells.size() == read_part(document, context).cells.cells.size());
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
    CHECK(removed_by(read_part_unfused(document.finish(), context, &one.tree)).IsSame(removed_by(one)));
    CHECK_FALSE(removed_by(read_part(document.finish(), context)).IsSame(removed_by(one)));
}
