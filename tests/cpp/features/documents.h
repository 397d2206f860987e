// SPDX-License-Identifier: GPL-3.0-or-later
// Hand-made raw documents.
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <utility>
#include <vector>

#include "brep/shapes.h"
#include "brep/written_shapes.h"
#include "features/raw_document.h"

namespace featuremesh::test {

class DocumentMaker {
  public:
    RawRecord& add(const std::string& name, const std::string& type, std::vector<RawLink> links = {},
                   const TopoDS_Shape& shape = {}, const TopoDS_Shape& own_volume = {}) {
        RawRecord record;
        record.name = record.label = name;
        record.type = type;
        record.links = std::move(links);
        record.shape = keep(shape);
        record.own_volume = keep(own_volume);
        document_.records.push_back(std::move(record));
        document_.final_object = name;
        return document_.records.back();
    }
    RawDocument done() const {
        RawDocument document = document_;
        document.shapes = write_shapes(shapes_);
        return document;
    }

  private:
    int keep(const TopoDS_Shape& shape) {
        if (shape.IsNull()) return -1;
        shapes_.push_back(shape);
        return static_cast<int>(shapes_.size()) - 1;
    }

    RawDocument document_;
    std::vector<TopoDS_Shape> shapes_;
};

}  // namespace featuremesh::test
