// SPDX-License-Identifier: GPL-3.0-or-later
// An operation on one corner of the tet.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "volume/improvement/local_mesh.h"
#include "volume/improvement/objective.h"
#include "volume/improvement/operation.h"
#include "volume/tets/tet_complex.h"

namespace featuremesh {

/// The vertices that an operation has tried in vain since their stars last changed. Threads share one list: whoever
/// comes first spares the others the same try.
class TriedMarks {
  public:
    /// Not at the same time as what other threads ask or note, unless there is room already.
    void make_room(const LocalMesh& mesh) { tried_at_.resize(mesh.complex().points.size(), 0); }
    bool has(int vertex, const LocalMesh& mesh) { return at(vertex).load(relaxed) >= mesh.changed_at(vertex); }
    void note(int vertex, const LocalMesh& mesh) { at(vertex).store(mesh.now(), relaxed); }

  private:
    static constexpr std::memory_order relaxed = std::memory_order_relaxed;
    std::atomic_ref<std::uint32_t> at(int vertex) {
        return std::atomic_ref<std::uint32_t>(tried_at_[static_cast<std::size_t>(vertex)]);
    }
    std::vector<std::uint32_t> tried_at_;
};

/// What it can do for a corner depends on the star of that alone, and is not tried again until this has changed.
class CornerOperation : public Operation {
  public:
    CornerOperation(const LocalMesh& mesh, const Objective& objective, std::shared_ptr<TriedMarks> tried)
        : mesh_(mesh), complex_(mesh.complex()), objective_(objective), tried_(std::move(tried)) {}

    void prepare() final { tried_->make_room(mesh_); }
    bool plan(int tet, Change& change, Footprint& footprint) final {
        tried_->make_room(mesh_);
        for (const int v : complex_.tets[tet]) {
            if (!may_help(complex_.mobility[v]) || tried_->has(v, mesh_)) continue;
            const bool is_found = plan_at(v, change);
            footprint.add(star_.tets);
            if (is_found) return true;
            tried_->note(v, mesh_);
        }
        return false;
    }

  protected:
    virtual bool may_help(Mobility corner) const = 0;
    /// As `plan`, for one vertex; its star is gathered in `star_`.
    virtual bool plan_at(int vertex, Change& change) = 0;

    const LocalMesh& mesh_;
    const TetComplex& complex_;
    const Objective& objective_;
    std::shared_ptr<TriedMarks> tried_;
    LocalMesh::Star star_;
};

}  // namespace featuremesh
