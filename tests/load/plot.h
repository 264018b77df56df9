// Plots as inline SVG. Colours are classes of the page's style sheet, so that they follow it.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace cutaway::load {

struct Line {
  std::string name;
  std::string css_class;                          ///< "a" or "b"
  std::vector<std::pair<double, double>> points;  ///< x, y
};

struct Bar {
  std::string label;  ///< shown where there is room, and in the bar's tooltip
  double value = 0.0;
};

struct Axes {
  std::string title;  ///< also read out instead of the picture
  std::string x;
  std::string y;
};

/// A sentence instead of the plot where there is nothing to show.
std::string line_plot(const Axes& axes, const std::vector<Line>& lines);
std::string bar_plot(const Axes& axes, const std::vector<Bar>& bars);

/// Text as HTML shows it.
std::string escaped(const std::string& text);

}  // namespace cutaway::load
