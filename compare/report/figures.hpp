#pragma once
// Figures by gnuplot: plot.gp of a study draws them, in the style of studies/style.gp.

#include <string>

namespace femsph::compare {

/// Runs the script once for SVG and once for PNG. The script finds these gnuplot variables:
///   format  "svg" or "png"      style  the common style to load
///   out     where figures go    data   where the series are
/// Throws std::runtime_error with one clear message when gnuplot is missing or the script fails.
void make_figures(const std::string& script, const std::string& style, const std::string& data,
                  const std::string& out);

}  // namespace femsph::compare
