#include "model/results/xdmf.hpp"

#include <fmt/format.h>

namespace femsph::xdmf {

namespace {

std::string escape(const std::string& text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  return out;
}

const char* topology_type(Topology::Kind kind) {
  switch (kind) {
    case Topology::Kind::quadrilaterals:
      return "Quadrilateral";
    case Topology::Kind::hexahedra:
      return "Hexahedron";
    case Topology::Kind::points:
      break;
  }
  return "Polyvertex";
}

std::string item(const char* number, std::size_t rows, std::size_t columns, const std::string& path) {
  return fmt::format(
      "<DataItem Format=\"HDF\" NumberType=\"{}\" Precision=\"8\" Dimensions=\"{} {}\">{}</DataItem>", number,
      rows, columns, path);
}

std::string attribute(const Field& field, const Body& body, const std::string& path) {
  const bool nodes = field.at_points || body.kind == Topology::Kind::points;
  return fmt::format("          <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">{}</Attribute>\n",
                     field.name, field.type, nodes ? "Node" : "Cell",
                     item("Float", nodes ? body.points : body.cells, field.components, path));
}

/// The time is written at every grid, since readers take it from different levels.
std::string grid(const Body& body, const Frame& frame, const std::string& geometry, const std::string& data) {
  std::string out = fmt::format(
      "        <Grid Name=\"{}\" GridType=\"Uniform\">\n          <Time Value=\"{}\"/>\n", escape(body.name),
      frame.time);
  out += fmt::format("          <Topology TopologyType=\"{}\" NumberOfElements=\"{}\"{}>{}</Topology>\n",
                     topology_type(body.kind), body.cells,
                     body.kind == Topology::Kind::points ? " NodesPerElement=\"1\"" : "",
                     item("Int", body.cells, body.cell_points(), geometry + "/cells"));
  out += fmt::format("          <Geometry GeometryType=\"XYZ\">{}</Geometry>\n",
                     item("Float", body.points, 3, geometry + "/points"));
  for (const Field& field : fields) out += attribute(field, body, data + "/" + field.name);
  if (body.plastic) out += attribute(plastic_strain, body, data + "/" + plastic_strain.name);
  for (const Field& field : recovered)
    if (body.both) out += attribute(field, body, data + "/" + field.name);
  if (body.both && body.plastic)
    out += attribute(recovered_plastic_strain, body, data + "/" + recovered_plastic_strain.name);
  return out + "        </Grid>\n";
}

}  // namespace

std::size_t Body::cell_points() const {
  switch (kind) {
    case Topology::Kind::quadrilaterals:
      return 4;
    case Topology::Kind::hexahedra:
      return 8;
    case Topology::Kind::points:
      break;
  }
  return 1;
}

std::string group(std::size_t body) { return fmt::format("/body{}", body); }

std::string document(const std::vector<Body>& bodies, const std::vector<Frame>& frames,
                     const std::string& geometry_file, const std::string& label) {
  std::string out =
      "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n    <Grid Name=\"" +
      escape(label) + "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (const Frame& frame : frames) {
    out += fmt::format(
        "      <Grid Name=\"step {}\" GridType=\"Collection\" CollectionType=\"Spatial\">\n        <Time "
        "Value=\"{}\"/>\n",
        frame.step, frame.time);
    for (std::size_t b : frame.bodies)
      out += grid(bodies[b], frame, geometry_file + ":" + group(b), frame.file + ":" + group(b));
    out += "      </Grid>\n";
  }
  return out + "    </Grid>\n  </Domain>\n</Xdmf>\n";
}

}  // namespace femsph::xdmf
