// SPDX-License-Identifier: GPL-3.0-or-later
#include "cells/solid_pieces.h"

#include <BOPAlgo_ShellSplitter.hxx>
#include <BOPTools_AlgoTools.hxx>
#include <BOPTools_CoupleOfShape.hxx>
#include <BOPTools_ListOfConnexityBlock.hxx>
#include <BOPTools_ListOfCoupleOfShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <IntTools_Context.hxx>
#include <Message_ProgressScope.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <optional>
#include <vector>

namespace featuremesh {

namespace {

TopoDS_Shell shell_of(const TopTools_ListOfShape& faces) {
    TopoDS_Shell shell;
    BRep_Builder builder;
    builder.MakeShell(shell);
    for (const TopoDS_Shape& face : faces) builder.Add(shell, face);
    shell.Closed(true);
    return shell;
}

/// The closed shells of connected faces, some of which are there in both orientations.
class ClosedShells {
  public:
    explicit ClosedShells(const TopTools_ListOfShape& faces) {
        for (const TopoDS_Shape& face : faces) add(TopoDS::Face(face));
    }

    /// Nothing where an edge lies within a face, or where they do not share out the faces among closed shells.
    std::optional<TopTools_ListOfShape> find() {
        if (has_inner_edges_) return std::nullopt;
        TopTools_ListOfShape shells;
        for (int f = 0; f < count(); ++f) {
            if (faces_[f].is_taken) continue;
            const std::vector<int> shell = grow_from(f);
            if (!is_closed(shell)) return std::nullopt;
            TopTools_ListOfShape list;
            for (const int g : shell) list.Append(faces_[g].face);
            shells.Append(shell_of(list));
        }
        return shells;
    }

  private:
    struct EdgeUse {
        TopoDS_Edge edge;  // as it runs along the face
        int number = 0;
    };
    struct Face {
        TopoDS_Face face;
        int number = 0;  // the same for both orientations
        std::vector<EdgeUse> edges;
        bool is_taken = false;
    };
    struct FaceUse {
        int face = 0;
        TopoDS_Edge edge;
    };

    int count() const { return static_cast<int>(faces_.size()); }
    bool is_on_border(int face) const { return uses_of_face_[faces_[face].number] == 1; }

    void add(const TopoDS_Face& face) {
        Face added{face, face_numbers_.Add(face) - 1, {}};
        uses_of_face_.resize(face_numbers_.Extent());
        ++uses_of_face_[added.number];
        for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
            if (edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED) has_inner_edges_ = true;
            if (BRep_Tool::Degenerated(edge)) continue;
            const int number = edge_numbers_.Add(edge) - 1;
            faces_of_edge_.resize(edge_numbers_.Extent());
            faces_of_edge_[number].push_back({count(), edge});
            added.edges.push_back({edge, number});
        }
        faces_.push_back(std::move(added));
        uses_in_shell_.resize(edge_numbers_.Extent());
    }

    void take(int face, std::vector<int>& shell) {
        faces_[face].is_taken = true;
        for (const EdgeUse& use : faces_[face].edges) ++uses_in_shell_[use.number];
        shell.push_back(face);
    }

    std::vector<int> grow_from(int start) {
        std::vector<int> shell;
        take(start, shell);
        for (std::size_t k = 0; k < shell.size(); ++k)
            for (std::size_t e = 0; e < faces_[shell[k]].edges.size(); ++e) {
                const EdgeUse& use = faces_[shell[k]].edges[e];
                if (uses_in_shell_[use.number] > 1) continue;
                if (const int next = next_at(use, shell[k]); next >= 0) take(next, shell);
            }
        return shell;
    }

    /// The face that comes next around the edge, seen from within the shell; -1 for none.
    int next_at(const EdgeUse& use, int face) {
        std::vector<FaceUse> candidates, inner;
        for (const FaceUse& other : faces_of_edge_[use.number]) {
            if (faces_[other.face].is_taken || faces_[other.face].number == faces_[face].number) continue;
            if (other.edge.Orientation() == use.edge.Orientation()) continue;
            candidates.push_back(other);
            if (!is_on_border(other.face)) inner.push_back(other);
        }
        if (candidates.empty()) return -1;
        // The one way inside from the border needs no angle, which is unsure where faces are tangent.
        if (is_on_border(face) && inner.size() == 1) return inner.front().face;
        if (candidates.size() == 1) return candidates.front().face;
        return nearest_by_angle(use, face, candidates);
    }

    int nearest_by_angle(const EdgeUse& use, int face, const std::vector<FaceUse>& candidates) {
        BOPTools_ListOfCoupleOfShape couples;
        for (const FaceUse& candidate : candidates) {
            BOPTools_CoupleOfShape couple;
            couple.SetShape1(candidate.edge);
            couple.SetShape2(faces_[candidate.face].face);
            couples.Append(couple);
        }
        TopoDS_Face nearest;
        BOPTools_AlgoTools::GetFaceOff(use.edge, faces_[face].face, couples, nearest, context_);
        for (const FaceUse& candidate : candidates)
            if (faces_[candidate.face].face.IsEqual(nearest)) return candidate.face;
        return -1;
    }

    /// Each edge of it has two faces or is the seam of one. Forgets the shell's edges.
    bool is_closed(const std::vector<int>& shell) {
        bool closed = true;
        for (const int face : shell)
            for (const EdgeUse& use : faces_[face].edges) closed = closed && uses_in_shell_[use.number] == 2;
        for (const int face : shell)
            for (const EdgeUse& use : faces_[face].edges) uses_in_shell_[use.number] = 0;
        return closed;
    }

    std::vector<Face> faces_;
    TopTools_IndexedMapOfShape face_numbers_, edge_numbers_;
    std::vector<int> uses_of_face_, uses_in_shell_;
    std::vector<std::vector<FaceUse>> faces_of_edge_;
    bool has_inner_edges_ = false;
    Handle(IntTools_Context) context_ = new IntTools_Context;
};

}  // namespace

void SolidPieces::PerformLoops(const Message_ProgressRange& range) {
    Message_ProgressScope scope(range, "shells", 1);
    BOPTools_ListOfConnexityBlock blocks;
    BOPTools_AlgoTools::MakeConnexityBlocks(myShapes, TopAbs_EDGE, TopAbs_FACE, blocks);
    myLoops.Clear();
    myLoopsInternal.Clear();
    TopTools_ListOfShape divided;
    for (BOPTools_ListOfConnexityBlock::Iterator it(blocks); it.More(); it.Next()) {
        if (UserBreak(scope)) return;
        if (it.Value().IsRegular()) {
            TopoDS_Shell shell = shell_of(it.Value().Shapes());
            BOPTools_AlgoTools::OrientFacesOnShell(shell);
            myLoops.Append(shell);
        } else {
            TopTools_ListOfShape shells = shells_of(it.ChangeValue());
            divided.Append(shells);
        }
    }
    myLoops.Append(divided);
    int taken = 0;
    for (const TopoDS_Shape& shell : myLoops) taken += shell.NbChildren();
    // What belongs to no shell is loose within a piece.
    if (!myShapesToAvoid.IsEmpty() || taken != myShapes.Extent()) BOPAlgo_BuilderSolid::PerformLoops(scope.Next());
}

TopTools_ListOfShape SolidPieces::shells_of(BOPTools_ConnexityBlock& block) const {
    if (const auto shells = ClosedShells(block.Shapes()).find()) return *shells;
    BOPAlgo_ShellSplitter::SplitBlock(block);
    for (TopTools_ListOfShape::Iterator it(block.ChangeLoops()); it.More(); it.Next()) it.ChangeValue().Closed(true);
    return block.Loops();
}

}  // namespace featuremesh
