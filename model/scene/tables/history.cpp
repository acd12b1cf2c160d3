// The history of a load or of a moved support in time: key "history", a word or an inline table.

#include <fmt/format.h>

#include <algorithm>

#include "model/scene/tables/reading.hpp"

namespace femsph::scene_reader {
namespace {

std::optional<TimeHistory> read_ramp(Fields& history) {
  const auto ramp = history.quantity("ramp", Need::required, dimension::time, Sign::positive);
  return ramp ? std::optional(TimeHistory{{0, *ramp}, {0, 1}}) : std::nullopt;
}

std::optional<TimeHistory> read_points(Fields& history) {
  const auto time = history.quantities("time", Need::required, dimension::time, Sign::not_negative);
  const auto factor = history.numbers("factor", Need::required);
  if (!time || !factor) return {};
  if (time->empty())
    return history.fault("time", "\"time\" is empty; expected at least one time"), std::nullopt;
  if (std::adjacent_find(time->begin(), time->end(), std::greater_equal<>()) != time->end())
    return history.fault("time", "the times do not increase; expected each time later than the one before"),
           std::nullopt;
  if (time->size() != factor->size())
    return history.fault("factor", fmt::format("{} factors for {} times; expected as many factors as times",
                                               factor->size(), time->size())),
           std::nullopt;
  return TimeHistory{*time, *factor};
}

}  // namespace

KeyTable history_keys(const std::string& header, const std::string& what) {
  return {
      header,
      "The factor on " + what +
          " over time, written inline: history = {ramp = \"1 ms\"} or history = {time = [..], factor = "
          "[..]}.",
      {{"ramp", key_holds::quantity(dimension::time), "The factor rises linearly from 0 to 1 in this time.",
        false, "unless \"time\" and \"factor\" are given"},
       {"time", key_holds::quantities(dimension::time), "Points in time, each later than the one before.",
        false, "with \"factor\""},
       {"factor", key_holds::numbers,
        "The factor at each of these times. Linear between them, constant before the first and after the "
        "last.",
        false, "with \"time\""}}};
}

Key history_key(const std::string& what) {
  return {
      "history", "a text or a table",
      "A factor on " + what + " over time. \"step\" is a factor of 1 from the start. \"step\" unless given."};
}

std::optional<TimeHistory> read_history(Fields& load) {
  const std::string expected = "\"step\", {ramp = \"10 ms\"} or {time = [..], factor = [..]}";
  if (!load.holds_table("history")) {
    const auto word = load.text("history", Need::optional, expected);
    if (word && *word != "step")
      load.fault("history", fmt::format("\"history\" is {}; expected {}{}", in_quotes(*word), expected,
                                        did_you_mean(*word, {"step"})));
    return TimeHistory{};
  }
  auto history = load.table("history", Need::optional, expected);
  const bool points = history->has("time") || history->has("factor");
  const auto read = points ? read_points(*history) : read_ramp(*history);
  history->done();
  return read;
}

}  // namespace femsph::scene_reader
