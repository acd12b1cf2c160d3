#pragma once
// Fields over space and time as HDF5 (data) + XDMF (what the data are), which ParaView opens.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/motion/bodies/discretization.hpp"

namespace femsph {

/// Removes what a FieldWriter has left in the folder, by the names that it gives.
void remove_earlier_fields(const std::string& folder);

/// Writes DIR/fields.xdmf, which ParaView opens, and the data it refers to: DIR/fields/bodies.h5 (reference
/// positions and cells, once) and one DIR/fields/NNNNNN.h5 per snapshot. The XDMF is a temporal collection of
/// spatial collections, one grid per body.
///
/// Every commit leaves a complete set: the snapshot's file and then a longer fields.xdmf appear by renaming,
/// and no file is touched again, so that a run that stops or is killed leaves its last good state on disk.
/// (One growing HDF5 file cannot promise that: a file being appended to when its program is killed may not
/// open again.)
class FieldWriter {
 public:
  /// Creates the folder and removes the fields of an earlier run from it, unless it is this run that is
  /// `taken_up` again. Throws std::runtime_error naming the file and the reason (folder not writable), as
  /// every call below does (disk full).
  explicit FieldWriter(const std::string& folder, bool taken_up = false);
  ~FieldWriter();

  /// Geometry of a body, which must outlive the writer; call once per body, before the first commit.
  /// FEM: its cells; SPH: vertices (Polyvertex). With `recovered`, the scene's plane, every snapshot also has
  /// stress and strain at the points by the rule of results/recovery.hpp. Returns the body's number for
  /// snapshot().
  std::size_t add_body(const std::string& name, const Discretization& body,
                       std::optional<Plane> recovered = {});

  /// Displacement and velocity at points; stress and strain (nine components, xx xy xz yx ..) and equivalent
  /// (von Mises) stress at material points: on SPH particles these are the points themselves; on FEM cells
  /// the volume-weighted mean of the cell's quadrature points (of the equivalent stress too: in a bent cell
  /// it is not that of the mean stress). Recovered values come from the same means, by weights found once: 8
  /// bytes for each unit near a point, some 13 in the plane and 35 in space.
  void snapshot(std::size_t body, long step, double time, const double* u, const double* v);
  /// Ends a snapshot of all bodies and puts it on disk. What was not committed is lost.
  void commit();
  /// The same while the caller goes on: the disk takes longer than composing a snapshot, and the files still
  /// appear in the same order, each synced before it is renamed. The next call of the writer waits for it and
  /// throws if it failed; until then what was on disk before is the last good state.
  void commit_later();
  /// Waits for commit_later(); throws as commit() does.
  void settle();
  /// Ends a snapshot that stands alone: DIR/NAME.xdmf, with its data in DIR/fields/NAME.h5, and `label` in
  /// it.
  void commit_alone(const std::string& name, const std::string& label);
  /// Which snapshots are on disk. What was written after the state was saved is written again.
  void state(Archive& archive);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace femsph
