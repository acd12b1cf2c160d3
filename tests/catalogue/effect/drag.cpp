// A dummy effect for tests/catalogue: drag, a force -k v spread over a body by mass.

#include "model/motion/effects/effect.hpp"
#include "model/scene/tables/reading.hpp"

namespace femsph {

namespace {

struct DragInput : EffectInput {
  double coefficient = 0;  ///< k, kg/s, of each body that deforms
};

/// f_i = -k (m_i / M) v_i, at the velocity half a step before. The energy that it takes in a step is
/// -1/2 dt v(n+1/2) . (f(n) + f(n+1)), as for every force.
class Drag : public Effect {
 public:
  explicit Drag(Motion& motion)
      : k_(input_of<DragInput>(motion.scene, "drag")->coefficient), force_(motion.bodies.size()) {}

  void push_body(const Motion& motion, MovingBody& body) override {
    const Layout& at = body.discretization->layout();
    const std::span<const double> mass = body.discretization->mass();
    AlignedVector<double>& force = force_[std::size_t(&body - motion.bodies.data())];
    force.resize(at.size);
    double all = 0;
    for (const double m : mass) all += m;
    for (std::size_t i = 0; i < at.points; ++i)
      for (int c = 0; c < at.dim; ++c) {
        const std::size_t slot = at.at(i, c);
        force[slot] = -k_ * mass[i] / all * body.v[slot];
        body.f[slot] += force[slot];
        loss_ -= 0.5 * motion.dt * body.v[slot] * force[slot];
      }
  }
  void after_kick(const Motion& motion, MovingBody& body, double&, double&) override {
    const AlignedVector<double>& force = force_[std::size_t(&body - motion.bodies.data())];
    for (std::size_t slot = 0; slot < body.v.size(); ++slot)
      loss_ -= 0.5 * motion.dt * body.v[slot] * force[slot];
  }
  void add_energies(Ledger& l) const override { l.damping += loss_; }
  void state(Archive& archive) override {
    archive.below("drag", [&] { archive("loss", loss_); });
  }
  void each_force(const Motion& motion, const MovingBody& body, const TakeForce& take) const override {
    const Layout& at = body.discretization->layout();
    for (std::size_t i = 0; i < at.points; ++i) {
      Point f{};
      for (int c = 0; c < at.dim; ++c)
        f[std::size_t(c)] = force_[std::size_t(&body - motion.bodies.data())][at.at(i, c)];
      take(i, f);
    }
  }
  void describe(const Motion&, std::vector<std::pair<std::string, std::string>>& lines) const override {
    lines.emplace_back("drag coefficient", std::to_string(k_) + " kg/s");
  }

 private:
  double k_, loss_ = 0;
  std::vector<AlignedVector<double>> force_;  ///< N, now
};

void read_drag(Fields& root, scene_reader::Reading& reading) {
  static constexpr Dimension coefficient{"kg/s", "a drag coefficient", "10 kg/s"};
  auto table = root.table("drag", Need::optional, "a table with coefficient = \"10 kg/s\" or the like");
  if (!table) return;
  auto input = std::make_shared<DragInput>();
  input->coefficient =
      table->quantity("coefficient", Need::required, coefficient, Sign::positive).value_or(1);
  table->done();
  reading.scene.effect_inputs["drag"] = input;
}

}  // namespace

EffectEntry drag_effect() {
  EffectEntry e{{"drag", "a force -k v on each body that deforms"}};
  e.asked_by = "[drag]";
  e.on = [](const Scene& s) { return input_of<DragInput>(s, "drag") != nullptr; };
  e.outside = true;
  e.tables = {
      {"[drag]", "Drag on every body that deforms.", {{"coefficient", "a drag coefficient", "k.", true}}}};
  e.read = read_drag;
  e.make = make_effect<Drag>;
  return e;
}

}  // namespace femsph
