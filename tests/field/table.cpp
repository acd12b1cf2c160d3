#include <fmt/format.h>

#include <algorithm>

#include "tests/field/case.hpp"

namespace femsph::field {
namespace {

std::string cell(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2))
    text.replace(at, 1, "\\|");
  return text;
}

int count(const Judged& judged, Verdict verdict) {
  return int(std::count_if(judged.findings.begin(), judged.findings.end(), [&](const Finding& f) {
    return f.verdict == verdict;
  }));
}

/// The verdict on a whole line.
std::string verdict_of(const Judged& judged) {
  const int all = int(judged.findings.size()),
            failed = count(judged, Verdict::fail) + count(judged, Verdict::closed),
            gaps = count(judged, Verdict::gap);
  const int refused = count(judged, Verdict::refused);
  if (failed) return fmt::format("FAIL ({} of {})", failed, all);
  if (gaps) return fmt::format("{} of {}; GAP", all - gaps, all);
  return refused == all ? word(Verdict::refused) : "PASS";
}

}  // namespace

std::string markdown(const std::vector<Judged>& all) {
  std::string text = "| # | met in | wanted | checks | verdict |\n|---|---|---|---|---|\n";
  for (const Judged& judged : all)
    text += fmt::format(
        "| {} | {} | {}: {} | {} | {} |\n", judged.row->number, cell(judged.row->source),
        cell(judged.row->title), cell(judged.row->wanted), judged.findings.size(), verdict_of(judged));
  text +=
      "\n### Every check\n\n| # | scene | method | what | right | found | verdict "
      "|\n|---|---|---|---|---|---|---|\n";
  for (const Judged& judged : all)
    for (const Finding& f : judged.findings)
      text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", judged.row->number, cell(f.scene),
                          f.method, cell(f.what), cell(f.right), cell(f.found), word(f.verdict));
  return text;
}

}  // namespace femsph::field
