// SPDX-License-Identifier: GPL-3.0-or-later
#include "cells/solid_splitter.h"

#include <BOPAlgo_PaveFiller.hxx>
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
#include <map>
#include <optional>

#include "cells/solid_pieces.h"

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

/// The first of the solids with the same faces, as arguments share the cells they have in common.
class SameSolids {
  public:
    const TopoDS_Shape& first_like(const TopoDS_Shape& solid) {
        std::vector<int> faces;
        for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) faces.push_back(numbers_.Add(it.Current()));
        std::sort(faces.begin(), faces.end());
        return first_.try_emplace(std::move(faces), solid).first->second;
    }

  private:
    TopTools_IndexedMapOfShape numbers_;
    std::map<std::vector<int>, TopoDS_Shape> first_;
};

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

/// A solid of the arguments that is not what it was.
struct SolidSplitter::Split {
    TopoDS_Shape solid;
    TopoDS_Solid draft;          // with what its faces were divided into
    TopTools_ListOfShape inner;  // faces
    SolidPieces pieces;          // if there are any
};

std::vector<TopoDS_Shape> SolidSplitter::images_of(const TopoDS_Shape& shape) const {
    const TopTools_ListOfShape* images = myImages.Seek(shape);
    if (!images) return {shape};
    std::vector<TopoDS_Shape> list;
    for (const TopoDS_Shape& image : *images) list.push_back(image);  // OCCT's iterators make no range of C++20
    if (shape.ShapeType() == TopAbs_SOLID)
        for (TopoDS_Shape& image : list) image.Orientation(shape.Orientation());
    return list;
}

void SolidSplitter::PerformInternal1(const BOPAlgo_PaveFiller& filler, const Message_ProgressRange& range) {
    myPaveFiller = const_cast<BOPAlgo_PaveFiller*>(&filler);  // the kernel does so, and only reads
    myDS = myPaveFiller->PDS();
    myContext = myPaveFiller->Context();
    Message_ProgressScope scope(range, "cells", 10);
    CheckData();
    if (HasErrors()) return;
    Prepare();
    split_faces(scope.Next(5));
    if (HasErrors()) return;
    split_solids(scope.Next(4));
    if (HasErrors()) return;
    collect();
    PostTreat(scope.Next());
}

/// All pieces: their tolerances are still to be brought in line. An argument may be a compound of solids.
void SolidSplitter::collect() {
    const BRep_Builder builder;
    TopTools_MapOfShape seen;
    for (int i = 0; i < myDS->NbSourceShapes(); ++i)
        if (const TopoDS_Shape& source = myDS->Shape(i); source.ShapeType() == TopAbs_SOLID)
            for (const TopoDS_Shape& piece : images_of(source))
                if (seen.Add(piece)) builder.Add(myShape, piece);
}

void SolidSplitter::split_faces(const Message_ProgressRange& range) {
    Message_ProgressScope scope(range, "faces", 10);
    FillImagesVertices(scope.Next());
    if (HasErrors()) return;
    FillImagesEdges(scope.Next());
    if (HasErrors()) return;
    FillImagesContainers(TopAbs_WIRE, scope.Next());  // tells the next step which faces have divided edges
    if (HasErrors()) return;
    FillImagesFaces(scope.Next(7));
}

void SolidSplitter::split_solids(const Message_ProgressRange& range) {
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
    Message_ProgressScope scope(range, "solids", 2);
    Message_ProgressScope search(scope.Next(), "faces within solids", static_cast<double>(solids.size()));
    std::deque<Split> splits;
    for (const int solid : solids) {
        if (UserBreak(search)) return;
        if (!find_inner_faces(faces, solid, splits.emplace_back(), search.Next())) splits.pop_back();
    }
    divide(splits, scope.Next());
    if (!HasErrors()) join(splits);
}

/// Does the solid have any, or was its border divided?
bool SolidSplitter::find_inner_faces(Faces& faces, int index, Split& split, const Message_ProgressRange& range) {
    BOPDS_ShapeInfo& source = myDS->ChangeShapeInfo(index);
    if (source.Box().IsVoid()) myDS->BuildBndBoxSolid(index, source.ChangeBox(), false);
    split.solid = source.Shape();
    BRep_Builder().MakeSolid(split.draft);
    TopTools_ListOfShape own_inner;
    BuildDraftSolid(split.solid, split.draft, own_inner);

    const TopTools_ListOfShape candidates = faces.within(split.draft, source.Box());
    if (!candidates.IsEmpty()) {
        TopTools_ListOfShape drafted;
        drafted.Append(split.draft);
        TopTools_DataMapOfShapeListOfShape own;
        own.Bind(split.draft, own_inner);
        faces.boxes().Bind(split.draft, source.Box());
        TopTools_IndexedDataMapOfShapeListOfShape found;
        BOPAlgo_Tools::ClassifyFaces(candidates, drafted, myRunParallel, myContext, found, faces.boxes(), own, range);
        split.inner = found.FindFromKey(split.draft);
    }
    bool is_split = !split.inner.IsEmpty();
    for (TopoDS_Iterator shell(split.solid); shell.More() && !is_split; shell.Next())
        is_split = are_faces_divided(shell.Value());
    split.inner.Append(own_inner);
    return is_split;
}

bool SolidSplitter::are_faces_divided(const TopoDS_Shape& shell) const {
    for (TopoDS_Iterator face(shell); face.More(); face.Next()) {
        const TopTools_ListOfShape* images = myImages.Seek(face.Value());
        if (images && (images->Extent() != 1 || !images->First().IsSame(face.Value()))) return true;
    }
    return false;
}

void SolidSplitter::divide(std::deque<Split>& splits, const Message_ProgressRange& range) {
    std::vector<Split*> divided;
    for (Split& split : splits) {
        if (split.inner.IsEmpty()) continue;
        TopTools_ListOfShape faces;
        for (TopExp_Explorer it(split.draft, TopAbs_FACE); it.More(); it.Next()) faces.Append(it.Current());
        for (const TopoDS_Shape& face : split.inner)
            for (const TopAbs_Orientation turned : {TopAbs_FORWARD, TopAbs_REVERSED})
                faces.Append(face.Oriented(turned));
        split.pieces.SetShapes(faces);
        split.pieces.SetRunParallel(myRunParallel);
        divided.push_back(&split);
    }
    Message_ProgressScope scope(range, "pieces", static_cast<double>(divided.size()));
    std::vector<Message_ProgressRange> ranges;
    for (std::size_t i = 0; i < divided.size(); ++i) ranges.push_back(scope.Next());
    parallel_for(context_, divided.size(), 1,
                 [&](std::size_t i, std::size_t) { divided[i]->pieces.Perform(ranges[i]); });
    UserBreak(scope);
}

void SolidSplitter::join(const std::deque<Split>& splits) {
    SameSolids same;
    TopTools_MapOfShape divided;
    for (const Split& split : splits) divided.Add(split.solid);
    for (int i = 0; i < myDS->NbSourceShapes(); ++i)
        if (const BOPDS_ShapeInfo& source = myDS->ShapeInfo(i);
            source.ShapeType() == TopAbs_SOLID && !divided.Contains(source.Shape()))
            same.first_like(source.Shape());
    for (const bool has_pieces : {false, true})
        for (const Split& split : splits) {
            if (split.inner.IsEmpty() == has_pieces) continue;
            TopTools_ListOfShape images;
            if (!has_pieces) images.Append(same.first_like(split.draft));
            for (const TopoDS_Shape& piece : split.pieces.Areas()) images.Append(same.first_like(piece));
            myImages.Bind(split.solid, images);
        }
}

}  // namespace featuremesh
