#include "compare/report/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <tuple>

#include "compare/measure/ladder.hpp"

namespace femsph::compare {
namespace {

struct RowColumn {
  const char* name;
  std::function<std::string(const Row&)> cell;
};

RowColumn words(const char* name, std::string Row::*member) {
  return {name, [member](const Row& row) { return csv_cell(row.*member); }};
}

RowColumn number(const char* name, std::optional<double> Row::*member) {
  return {name, [member](const Row& row) { return csv_number(row.*member); }};
}

const std::vector<RowColumn>& row_columns() {
  static const std::vector<RowColumn> columns = {
      words("study", &Row::study),
      words("case", &Row::case_name),
      words("method", &Row::method),
      number("spacing_mm", &Row::spacing_mm),
      number("cells_over_height", &Row::cells_over_height),
      words("quantity", &Row::quantity),
      number("value", &Row::value),
      words("unit", &Row::unit),
      number("theory", &Row::theory),
      number("error_percent", &Row::error_percent),
      number("limit", &Row::limit),
      number("error_vs_limit_percent", &Row::error_vs_limit_percent),
      number("paper", &Row::paper),
      number("paper_error_percent", &Row::paper_error_percent),
      number("steps", &Row::steps),
      number("dt_s", &Row::dt_s),
      number("cpu_s", &Row::cpu_s),
      number("wall_s", &Row::wall_s),
      number("threads", &Row::threads),
      number("points", &Row::points),
      number("ns_per_unit_step", &Row::ns_per_unit_step),
      number("dof", &Row::dof),
      number("memory_mb", &Row::memory_mb),
      number("total_cpu_s", &Row::total_cpu_s),
      number("total_cpu_min_s", &Row::total_cpu_min_s),
      number("total_cpu_max_s", &Row::total_cpu_max_s),
      number("repeats", &Row::repeats),
      number("energy_imbalance_percent", &Row::energy_imbalance_percent),
      number("momentum_error", &Row::momentum_error),
      {"settled",
       [](const Row& row) {
         return std::string(!row.settled ? "" : *row.settled ? "yes" : "no");
       }},
      words("failure", &Row::failure),
  };
  return columns;
}

std::string list(const std::vector<double>& values) {
  std::string all;
  for (const double value : values)
    all += (all.empty() ? "" : " ") + (std::isnan(value) ? "-" : fmt::format("{:.4g}", value));
  return all;
}

Order order_of(const std::vector<const Row*>& rungs, Reference reference) {
  const Row& first = *rungs.front();
  Order order{
      first.study, first.method, first.quantity, reference == Reference::theory ? "theory" : "limit", {}, {},
      {},          {},           first.unit};
  Ladder errors, values;
  for (const Row* row : rungs) {
    errors.push_back({*row->spacing_mm, *error_of(*row, reference)});
    values.push_back({*row->spacing_mm, *row->value});
    order.spacings_mm.push_back(*row->spacing_mm);
  }
  order.pairwise = pairwise_orders(errors);
  order.observed = fitted_order(errors);
  const bool a_distance = !first.theory &&
                          !first.limit;  // l2: the value is an error itself, whose limit is no result
  if (const auto extrapolation = richardson(values);
      extrapolation && !a_distance && is_convergence(extrapolation->order))
    order.extrapolated = extrapolation->limit;
  return order;
}

}  // namespace

std::optional<double> error_of(const Row& row, Reference reference) {
  const auto error = reference == Reference::value    ? row.value
                     : reference == Reference::theory ? row.error_percent
                                                      : row.error_vs_limit_percent;
  return error && std::isfinite(*error) ? error : std::nullopt;
}

std::vector<Order> orders_of(const std::vector<Row>& rows) {
  using Key = std::tuple<std::string, int, std::string, std::string>;
  std::vector<Key> keys;  // in the order of the rows
  std::map<Key, std::vector<const Row*>> ladders;
  for (const Row& row : rows) {
    const Key key{row.study, row.ladder, row.method, row.quantity};
    if (!ladders.contains(key)) keys.push_back(key);
    ladders[key].push_back(&row);
  }
  std::vector<Order> orders;
  for (const Key& key : keys)
    for (const Reference reference : {Reference::theory, Reference::limit}) {
      std::vector<const Row*> rungs = ladders[key];
      std::erase_if(rungs, [&](const Row* row) {
        return !row->value || !row->spacing_mm || !error_of(*row, reference) || row->settled == false;
      });
      std::stable_sort(rungs.begin(), rungs.end(),
                       [](const Row* a, const Row* b) { return *a->spacing_mm > *b->spacing_mm; });
      const bool rises = std::adjacent_find(rungs.begin(), rungs.end(), [](const Row* a, const Row* b) {
                           return *a->spacing_mm == *b->spacing_mm;
                         }) == rungs.end();
      if (rungs.size() >= 2 && rises) orders.push_back(order_of(rungs, reference));
    }
  return orders;
}

std::string csv_number(double value) { return std::isfinite(value) ? fmt::format("{:.10g}", value) : ""; }

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string csv_number(const std::optional<double>& value) { return value ? csv_number(*value) : ""; }

std::string csv_line(const std::vector<std::string>& cells) {
  std::string text = csv_cell(cells.at(0));
  for (std::size_t i = 1; i < cells.size(); ++i) text += "," + csv_cell(cells[i]);
  return text + "\r\n";
}

std::string csv(const std::vector<Row>& rows) {
  std::string text;
  for (const RowColumn& column : row_columns()) text += (text.empty() ? "" : ",") + std::string(column.name);
  text += "\r\n";
  for (const Row& row : rows) {
    bool first = true;
    for (const RowColumn& column : row_columns()) {
      text += (first ? "" : ",") + column.cell(row);
      first = false;
    }
    text += "\r\n";
  }
  return text;
}

std::string csv(const std::vector<Order>& orders) {
  std::string text =
      "study,method,quantity,reference,spacings_mm,observed_order,pairwise_orders,extrapolated,unit\r\n";
  for (const Order& order : orders)
    text += csv_line(
        {order.study, order.method, order.quantity, order.reference, list(order.spacings_mm),
         csv_number(order.observed), list(order.pairwise), csv_number(order.extrapolated), order.unit});
  return text;
}

}  // namespace femsph::compare
