#include "compare/run/capacity.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "sph/formulations/discretize.hpp"

namespace femsph::compare {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double most_units =
    2e8;  // offsets of the FEM kernels are 32-bit: three components of at most 5e8 slots

/// Peak bytes for each unit: the growth of the program's peak memory (set-up and one field snapshot),
/// measured with elastic bodies of about 1.4e5 units on a regular lattice or mesh. What plasticity and
/// irregular particles add is counted from the arrays, not measured.
double bytes_of_unit(const Scene& scene, const Body& body, const Method& method) {
  const int dim = scene.dim(), symmetric = dim * (dim + 1) / 2;
  const bool plastic = scene.material_of(body).yields();
  const double state = plastic ? 8.0 * (2 * symmetric + 3) : 0.0;  // of the state of a material point
  if (method.is_fem()) {
    const auto& element = fem::element_named(std::get<fem::Options>(method.options).element);
    return (dim == 2 ? 1300 : 2000) + state * element.points[dim == 2 ? 0 : 1];
  }
  const auto& options = std::get<sph::Options>(method.options);
  const sph::Formulation& formulation = sph::formulation_named(options.formulation);
  const bool corrected = formulation.corrected;
  if (scene.large_motion && formulation.bytes[0] > 0) return formulation.bytes[dim == 2 ? 0 : 1] + state;
  const bool scattered = options.jitter > 0 || sph::is_fitted(*body.shape, options);
  const double rows = scattered ? (dim == 2 ? 600 : 2200) * std::pow(options.smoothing / 1.2, dim) : 0.0;
  const double projected = corrected && options.projection ? 2 : 1;  // the rows of the adjoint are stored too
  const bool mean = corrected &&
                    sph::wants_mean_dilatation(options, scene.material_of(body).law(scene.plane));
  const double averaged = mean ? (dim == 2 ? 60 : 110) + (scattered ? dim == 2 ? 160 : 520 : 0)
                               : 0;  // gradients, two values, their rows
  return (dim == 2 ? 1000 : 1200) + projected * rows + averaged + state;
}

/// Cells or particles of a body: those of its bounding box times its share of the box's volume.
double units_of(const Shape& shape, const Method& method, const Resolution& resolution) {
  if (method.is_fem() && shape.cells()) return double(shape.cells()->cells.size());
  double box = 1, count = 1;
  for (int a = 0; a < shape.dim(); ++a) {
    const double length = shape.upper()[a] - shape.lower()[a];
    box *= length;
    double spacing = resolution.spacing;
    if (!(spacing > 0))
      spacing = (shape.upper()[1] - shape.lower()[1]) / std::max(1, resolution.divisions[1]);
    const double cells = resolution.divisions[a] > 0 && method.is_fem() ? double(resolution.divisions[a])
                                                                        : length / spacing;
    count *= method.is_fem() ? std::max(1.0, cells) : cells + 1;
  }
  return count * shape.measure() / box;
}

/// The number of bytes that a file states; infinity if it states none ("max") or does not exist.
double number_in(const std::string& file) {
  std::ifstream in(file);
  double value = 0;
  return in >> value ? value : infinity;
}

std::string bytes_text(double bytes) {
  for (const auto& [size, unit] : {std::pair{1e15, "PB"}, {1e12, "TB"}, {1e9, "GB"}})
    if (bytes >= size) return fmt::format("{:.2g} {}", bytes / size, unit);
  return fmt::format("{:.2g} MB", bytes / 1e6);
}

}  // namespace

Size estimated_size(const Scene& scene, const BodyMethods& methods, const Resolution& resolution) {
  Size size;
  for (const Body& body : scene.bodies) {
    if (body.rigid) continue;
    const Method& method = methods.of(body);
    const double units = units_of(*body.shape, method, resolution);
    size.units += units;
    size.bytes += units * bytes_of_unit(scene, body, method);
  }
  return size;
}

double available_memory() {
  double available = infinity;
  std::ifstream machine("/proc/meminfo");
  for (std::string key, rest; machine >> key; std::getline(machine, rest))
    if (double kilobytes = 0; key == "MemAvailable:" && machine >> kilobytes) available = 1024 * kilobytes;
  const std::string two = "/sys/fs/cgroup/", one = "/sys/fs/cgroup/memory/";
  const auto left = [](double limit, double used) {
    return std::isfinite(limit) && std::isfinite(used) ? std::max(0.0, limit - used) : infinity;
  };
  available = std::min(available, left(number_in(two + "memory.max"), number_in(two + "memory.current")));
  return std::min(
      available, left(number_in(one + "memory.limit_in_bytes"), number_in(one + "memory.usage_in_bytes")));
}

void refuse_excess(const Scene& scene, const BodyMethods& methods, const Resolution& resolution,
                   double available) {
  if (!(resolution.spacing > 0) && resolution.divisions[0] <= 0)
    return;  // no resolution: reported elsewhere, or the cells come from a mesh file
  const Size size = estimated_size(scene, methods, resolution);
  const double over = std::max(size.bytes / available, size.units / most_units);
  if (!(over > 1)) return;
  const std::string units = methods.all_fem()   ? "elements"
                            : methods.all_sph() ? "particles"
                                                : "particles and elements";
  const std::string what = fmt::format(
      "this {} gives about {:.2g} {}, which need {} of memory; ",
      resolution.spacing > 0 ? "spacing" : "division", size.units, units, bytes_text(size.bytes));
  const std::string limit = size.bytes / available >= size.units / most_units
                                ? bytes_text(available) + " are available"
                                : fmt::format("the program supports {:.1g} at most", most_units);
  const double factor = 1.03 * std::pow(over, 1.0 / scene.dim());
  std::string advice = fmt::format("use {:.2g} times fewer divisions along each side", factor);
  if (resolution.spacing > 0) {
    const double finest = resolution.spacing * factor,
                 digit = std::pow(10, std::floor(std::log10(finest)) - 1);
    advice = fmt::format("use a spacing of at least {:.2g} mm", 1e3 * digit * std::ceil(finest / digit));
  }
  throw std::runtime_error(what + limit + "; " + advice);
}

}  // namespace femsph::compare
