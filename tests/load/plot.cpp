#include "load/plot.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "load/figures.h"

namespace cutaway::load {

namespace {

constexpr double kWidth = 720.0;
constexpr double kHeight = 240.0;
constexpr double kLeft = 64.0;
constexpr double kRight = 12.0;
constexpr double kTop = 14.0;
constexpr double kBottom = 44.0;
constexpr int kTicks = 4;
constexpr std::size_t kLabels = 12;  // along x

/// A number that four steps divide well, not below `value`.
double round_up(double value) {
  if (value <= 0.0) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 1.2, 1.6, 2.0, 2.4, 3.2, 4.0, 5.0, 6.0, 8.0}) {
    if (value <= step * power) return step * power;
  }
  return 10.0 * power;
}

/// Maps data to the picture.
class Frame {
 public:
  Frame(const Axes& axes, double x_most, double y_most)
      : x_most_(x_most), y_most_(round_up(y_most)) {
    out_ << "<figure><figcaption>" << escaped(axes.title) << "</figcaption><svg viewBox=\"0 0 "
         << kWidth << ' ' << kHeight << "\" role=\"img\" aria-label=\"" << escaped(axes.title)
         << "\">";
    draw_y_axis(axes.y);
    text(kLeft + 0.5 * (kWidth - kLeft - kRight), kHeight - 6.0, "middle", axes.x);
  }

  double x(double value) const { return kLeft + value / x_most_ * (kWidth - kLeft - kRight); }
  double y(double value) const {
    return kHeight - kBottom - value / y_most_ * (kHeight - kTop - kBottom);
  }
  std::ostream& out() { return out_; }
  void text(double at_x, double at_y, const char* anchor, const std::string& words) {
    out_ << "<text x=\"" << at_x << "\" y=\"" << at_y << "\" text-anchor=\"" << anchor << "\">"
         << escaped(words) << "</text>";
  }
  void x_label(double value, const std::string& words) {
    text(x(value), kHeight - kBottom + 16.0, "middle", words);
  }
  std::string finish() {
    out_ << "</svg></figure>\n";
    return out_.str();
  }

 private:
  void draw_y_axis(const std::string& name) {
    for (int i = 0; i <= kTicks; ++i) {
      const double value = y_most_ * i / kTicks;
      out_ << "<path class=\"grid\" d=\"M" << kLeft << ' ' << y(value) << 'H' << kWidth - kRight
           << "\"/>";
      text(kLeft - 6.0, y(value) + 4.0, "end", figure(value));
    }
    out_ << "<text transform=\"translate(12 " << 0.5 * (kHeight - kBottom + kTop)
         << ") rotate(-90)\" text-anchor=\"middle\">" << escaped(name) << "</text>";
  }

  std::ostringstream out_;
  double x_most_;
  double y_most_;
};

std::string nothing(const Axes& axes) {
  return "<figure><figcaption>" + escaped(axes.title) +
         "</figcaption><p>Nothing was measured.</p></figure>\n";
}

void draw_line(Frame& frame, const Line& line) {
  frame.out() << "<path class=\"line " << line.css_class << "\" d=\"";
  char command = 'M';
  for (const auto& [x, y] : line.points) {
    frame.out() << command << frame.x(x) << ' ' << frame.y(y);
    command = 'L';
  }
  frame.out() << "\"><title>" << escaped(line.name) << "</title></path>";
}

void draw_legend(Frame& frame, const std::vector<Line>& lines) {
  double x = kLeft + 8.0;
  for (const Line& line : lines) {
    frame.out() << "<path class=\"line " << line.css_class << "\" d=\"M" << x << " 8h18\"/>";
    frame.text(x + 24.0, 12.0, "start", line.name);
    x += 110.0;
  }
}

}  // namespace

std::string line_plot(const Axes& axes, const std::vector<Line>& lines) {
  double x_most = 0.0;
  double y_most = 0.0;
  for (const Line& line : lines) {
    for (const auto& [x, y] : line.points) {
      x_most = std::max(x_most, x);
      y_most = std::max(y_most, y);
    }
  }
  if (x_most <= 0.0) return nothing(axes);
  Frame frame(axes, x_most, y_most);
  for (const Line& line : lines) draw_line(frame, line);
  if (lines.size() > 1) draw_legend(frame, lines);
  for (int i = 0; i <= kTicks; ++i) frame.x_label(x_most * i / kTicks, figure(x_most * i / kTicks));
  return frame.finish();
}

std::string bar_plot(const Axes& axes, const std::vector<Bar>& bars) {
  if (bars.empty()) return nothing(axes);
  const auto count = static_cast<double>(bars.size());
  Frame frame(axes, count, std::ranges::max_element(bars, {}, &Bar::value)->value);
  const std::size_t every = (bars.size() + kLabels - 1) / kLabels;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const auto place = static_cast<double>(i);
    const double top = frame.y(bars[i].value);
    frame.out() << "<rect class=\"bar\" x=\"" << frame.x(place + 0.1) << "\" y=\"" << top
                << "\" width=\"" << frame.x(0.8) - frame.x(0.0) << "\" height=\""
                << frame.y(0.0) - top << "\"><title>" << escaped(bars[i].label) << ": "
                << figure(bars[i].value) << "</title></rect>";
    if (i % every == 0) frame.x_label(place + 0.5, bars[i].label);
  }
  return frame.finish();
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

}  // namespace cutaway::load
