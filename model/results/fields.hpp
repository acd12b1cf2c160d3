#pragma once
// Fields for ParaView: HDF5 files with the data, and an XDMF file that describes them.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/motion/bodies/discretization.hpp"

namespace femsph {

/// Removes the files of a FieldWriter from the folder.
void remove_earlier_fields(const std::string& folder);

/// Writes DIR/fields.xdmf, which ParaView opens, and its data: DIR/fields/bodies.h5 (undeformed positions and
/// cells, once) and one DIR/fields/NNNNNN.h5 for each snapshot. The XDMF is a temporal collection of spatial
/// collections, one grid per body.
///
/// Every commit leaves a complete set of files: first the file of the snapshot and then a longer fields.xdmf
/// are renamed into place, and data files are never modified, so that a run that is stopped or killed leaves
/// all earlier snapshots readable. (A single HDF5 file that grows may be unreadable if the program is killed
/// while it is written.)
class FieldWriter {
 public:
  /// Creates the folder, and removes the fields of an earlier run unless this run is resumed (`taken_up`).
  /// This and all calls below throw std::runtime_error with the file and the reason (folder not writable,
  /// disk full).
  explicit FieldWriter(const std::string& folder, bool taken_up = false);
  ~FieldWriter();

  /// Writes the geometry of a body: the cells of FEM, or vertices (Polyvertex) for particles. Call it once
  /// for each body before the first commit; the body must outlive the writer. With `recovered` (the plane of
  /// the scene) every snapshot also has recovered stress and strain at the points (results/recovery.hpp).
  /// Returns the number of the body for snapshot().
  std::size_t add_body(const std::string& name, const Discretization& body,
                       std::optional<Plane> recovered = {});

  /// Displacement and velocity at points; stress and strain (nine components, xx xy xz yx ..) and equivalent
  /// (von Mises) stress of particles or cells. Values of a cell are means of its quadrature points weighted
  /// by volume. The equivalent stress is such a mean too; in a bent cell it differs from the equivalent
  /// stress of the mean stress. Recovered values are weighted sums of these means, with weights that are
  /// computed once (8 bytes for each unit near a point, about 13 units in a plane and 35 in space).
  void snapshot(std::size_t body, long step, double time, const double* u, const double* v);
  /// Ends a snapshot of all bodies and writes it to disk. A snapshot without a commit is lost.
  void commit();
  /// The same in the background. The files still appear in the same order, each synced before it is renamed.
  /// The next call of the writer waits for it, and throws if it has failed.
  void commit_later();
  /// Waits for commit_later(); throws as commit() does.
  void settle();
  /// Ends a snapshot that stands alone: DIR/NAME.xdmf, with its data in DIR/fields/NAME.h5, and `label` in
  /// it.
  void commit_alone(const std::string& name, const std::string& label);
  /// Saves or restores which snapshots are on disk. Snapshots that were written after the state was saved are
  /// written again.
  void state(Archive& archive);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace femsph
