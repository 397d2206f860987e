// SPDX-License-Identifier: GPL-3.0-or-later
#include "cells/solid_splitter.h"

#include <BOPAlgo_Tools.hxx>
#include <BOPDS_DS.hxx>
#include <BOPTools_BoxTree.hxx>
#include <BRepBndLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Tools.hxx>
#include <Message_ProgressScope.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <vector>

namespace featuremesh {

namespace {

/// Of the vertices, none of them smaller than its tolerance; of a face without any, of the face.
Bnd_Box box_of_vertices(const TopoDS_Shape& face) {
    Bnd_Box box;
    for (TopExp_Explorer it(face, TopAbs_VERTEX); it.More(); it.Next()) {
        const TopoDS_Vertex& vertex = TopoDS::Vertex(it.Current());
        box.Add(BRep_Tool::Pnt(vertex));
        box.SetGap(std::max(box.GetGap(), BRep_Tool::Tolerance(vertex)));
    }
    if (box.IsVoid()) BRepBndLib::Add(face, box);
    return box;
}

bool is_within(const Bnd_Box& vertices, const Bnd_Box& solid) {
    if (solid.IsWhole()) return true;
    const gp_Pnt low = solid.CornerMin(), high = solid.CornerMax();
    const gp_Pnt inner_low = vertices.CornerMin(), inner_high = vertices.CornerMax();
    const double slack = 2 * vertices.GetGap();
    for (int i = 1; i <= 3; ++i)
        if (inner_low.Coord(i) + slack < low.Coord(i) || inner_high.Coord(i) - slack > high.Coord(i)) return false;
    return true;
}

}  // namespace

/// What became of the faces of all arguments, each once.
class SolidSplitter::Faces {
  public:
    void add(const TopoDS_Shape& face) {
        if (!seen_.Add(face)) return;
        faces_.push_back(face);
        boxes_.push_back(box_of_vertices(face));
        box_of_.Bind(face, boxes_.back());
        tree_.Add(static_cast<int>(boxes_.size()) - 1, Bnd_Tools::Bnd2BVH(boxes_.back()));
    }

    /// Those that may be within the solid, in the order in which they were added.
    TopTools_ListOfShape within(const TopoDS_Shape& solid, const Bnd_Box& box) const {
        BOPTools_BoxTreeSelector selector;
        selector.SetBox(Bnd_Tools::Bnd2BVH(box));
        selector.SetBVHSet(const_cast<BOPTools_BoxTree*>(&tree_));  // the kernel asks for it so, and only reads
        selector.Select();
        TopTools_IndexedMapOfShape own;
        TopExp::MapShapes(solid, TopAbs_FACE, own);
        std::vector<int> found;
        for (TColStd_ListOfInteger::Iterator it(selector.Indices()); it.More(); it.Next())
            if (is_within(boxes_[it.Value()], box) && !own.Contains(faces_[it.Value()])) found.push_back(it.Value());
        std::sort(found.begin(), found.end());
        TopTools_ListOfShape list;
        for (const int index : found) list.Append(faces_[index]);
        return list;
    }

    /// By face, and by solid where the kernel is not to work them out.
    TopTools_DataMapOfShapeBox& boxes() { return box_of_; }

  private:
    TopTools_MapOfShape seen_;
    std::vector<TopoDS_Shape> faces_;
    std::vector<Bnd_Box> boxes_;
    TopTools_DataMapOfShapeBox box_of_;
    BOPTools_BoxTree tree_;
};

void SolidSplitter::FillIn3DParts(TopTools_DataMapOfShapeShape& drafts, const Message_ProgressRange& range) {
    Faces faces;
    std::vector<int> solids;
    for (int i = 0; i < myDS->NbSourceShapes(); ++i) {
        const BOPDS_ShapeInfo& source = myDS->ShapeInfo(i);
        if (source.ShapeType() == TopAbs_SOLID) solids.push_back(i);
        if (source.ShapeType() != TopAbs_FACE) continue;
        if (const TopTools_ListOfShape* pieces = myImages.Seek(source.Shape()))
            for (const TopoDS_Shape& piece : *pieces) faces.add(piece);
        else
            faces.add(source.Shape());
    }
    Message_ProgressScope scope(range, "faces within solids", static_cast<double>(solids.size()));
    for (const int solid : solids) {
        if (UserBreak(scope)) return;
        find_inner_faces(faces, solid, drafts, scope.Next());
    }
}

void SolidSplitter::find_inner_faces(Faces& faces, int index, TopTools_DataMapOfShapeShape& drafts,
                                     const Message_ProgressRange& range) {
    BOPDS_ShapeInfo& source = myDS->ChangeShapeInfo(index);
    if (source.Box().IsVoid()) myDS->BuildBndBoxSolid(index, source.ChangeBox(), false);
    const TopoDS_Solid solid = TopoDS::Solid(source.Shape());
    TopoDS_Solid draft;
    BRep_Builder().MakeSolid(draft);
    TopTools_ListOfShape own_inner, inner;
    BuildDraftSolid(solid, draft, own_inner);

    const TopTools_ListOfShape candidates = faces.within(draft, source.Box());
    if (!candidates.IsEmpty()) {
        TopTools_ListOfShape drafted;
        drafted.Append(draft);
        TopTools_DataMapOfShapeListOfShape own;
        own.Bind(draft, own_inner);
        faces.boxes().Bind(draft, source.Box());
        TopTools_IndexedDataMapOfShapeListOfShape found;
        BOPAlgo_Tools::ClassifyFaces(candidates, drafted, myRunParallel, myContext, found, faces.boxes(), own, range);
        inner = found.FindFromKey(draft);
    }
    bool is_split = !inner.IsEmpty();
    for (TopoDS_Iterator shell(solid); shell.More() && !is_split; shell.Next())
        is_split = myImages.IsBound(shell.Value());
    if (!is_split) return;
    drafts.Bind(solid, draft);
    inner.Append(own_inner);
    if (!inner.IsEmpty()) myInParts.Bind(solid, inner);
}

}  // namespace featuremesh
