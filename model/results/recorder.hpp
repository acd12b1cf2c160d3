#pragma once
// Reads the scene's probes and sections off a march: the same reading for both solvers.

#include <map>
#include <string>
#include <vector>

#include "model/motion/balance.hpp"
#include "model/results/history.hpp"

namespace femsph {

class Recorder {
 public:
  /// Finds the weights of every probe and section point once.
  explicit Recorder(const March& march);

  /// One row of the history: time, every probe's components (NAME_x, ..), energies in J, momenta, rigid
  /// bodies, contacts, reactions.
  void sample(const March& march);
  const History& history() const { return history_; }
  void state(Archive& archive);  ///< the rows so far
  /// The worst of all samples so far.
  const Balance& balance() const { return balance_; }
  /// Every section of the scene as it is now, by name.
  std::map<std::string, Profile> profiles(const March& march) const;

 private:
  struct Reading {
    std::string name;
    std::size_t body;
    const Quantity* quantity;
    std::vector<Weight> weights;  ///< of points, or of material points for stress and strain
    bool raw = false;  ///< stress and strain as the discretization interpolates them, not by recovery.hpp
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
  std::vector<Reaction> reactions_;    ///< of all that hold
  std::vector<std::size_t> reported_;  ///< which of them have a name
  Balance balance_;
  History history_;
};

}  // namespace femsph
