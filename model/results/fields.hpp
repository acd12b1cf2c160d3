#pragma once
// Fields over space and time as HDF5 (data) + XDMF (what the data are), which ParaView opens.

#include <memory>
#include <string>
#include <vector>

#include "model/motion/discretization.hpp"

namespace femsph {

/// Writes DIR/fields.h5 and DIR/fields.xdmf: one grid per body and snapshot in a temporal collection.
/// Every snapshot leaves both files complete and readable: the data are appended and flushed to fields.h5, then fields.xdmf is
/// written to a temporary name and renamed, so that a run that stops or is killed leaves its last good state on disk.
class FieldWriter {
 public:
  /// Throws std::runtime_error naming the file and the reason (folder not writable, disk full).
  explicit FieldWriter(const std::string& folder);
  ~FieldWriter();

  /// Geometry of a body; call once per body, before snapshots. FEM: its cells; SPH: vertices (Polyvertex).
  std::size_t add_body(const std::string& name, const Discretization& body);

  /// Displacement, velocity and reference position at points; stress and strain (six components), equivalent (von Mises) stress
  /// at material points: on SPH particles these are the points themselves; on FEM cells the mean of the cell's quadrature points.
  void snapshot(std::size_t body, long step, double time, const double* u, const double* v);
  /// Ends a snapshot of all bodies: flushes, renames.
  void commit();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace femsph
