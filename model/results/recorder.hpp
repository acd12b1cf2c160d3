#pragma once
// Reads the probes and sections of a scene during a run, in the same way for both solvers.

#include <map>
#include <string>
#include <vector>

#include "model/motion/balance.hpp"
#include "model/results/history.hpp"

namespace femsph {

class Recorder {
 public:
  /// Computes the weights of all points of probes and sections once.
  explicit Recorder(const March& march);

  /// Adds a row to the history (columns: history_columns.hpp).
  void sample(const March& march);
  const History& history() const { return history_; }
  void state(Archive& archive);  ///< saves or restores the rows so far
  /// The largest imbalance of all samples so far.
  const Balance& balance() const { return balance_; }
  /// All sections of the scene at the present time, by name.
  std::map<std::string, Profile> profiles(const March& march) const;

 private:
  struct Reading {
    std::string name;
    std::size_t body;
    const Quantity* quantity;
    std::vector<Weight> weights;  ///< of points; of material points for stress and strain
    bool raw = false;  ///< stress and strain by the method's own interpolation instead of recovery.hpp
  };
  std::vector<double> read(const March& march, const Reading& reading) const;
  std::vector<double> read_material(const March& march, const Reading& reading) const;

  std::vector<Reading> probes_;
  struct Line {
    const Section* section;
    std::vector<double> distance;
    std::vector<Reading> points;
  };
  std::vector<Line> lines_;
  std::vector<Reaction> reactions_;    ///< of all supports
  std::vector<std::size_t> reported_;  ///< indices of those with a name
  Balance balance_;
  History history_;
};

}  // namespace femsph
