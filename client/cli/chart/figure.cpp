#include "client/cli/chart/figure.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "client/cli/chart/labels.h"

namespace gonio::cli {
namespace {

constexpr double kLeft = 62, kRight = 14, kTop = 26, kBottom = 46;  // around a panel's plot
constexpr double kCaption = 30;
constexpr double kFont = 11, kLabelFont = 9.5;
constexpr const char* kInk = "#222222";

std::string text_of(double x) {
  char text[32];
  std::snprintf(text, sizeof(text), std::isnan(x) ? "NaN" : "%.7g", x);
  return text;
}

// Inside a script's double quotes.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

// A plot's rectangle on the page, in pixels from the lower left.
struct Frame {
  Box box;
  double width, height;  // of the page

  [[nodiscard]] std::string margins() const {
    return "set lmargin at screen " + text_of(box.left / width) + "; set rmargin at screen " +
           text_of(box.right / width) + "; set bmargin at screen " + text_of(box.bottom / height) +
           "; set tmargin at screen " + text_of(box.top / height) + "\n";
  }
  [[nodiscard]] std::string screen(double x, double y) const {
    return "screen " + text_of(x / width) + ", screen " + text_of(y / height);
  }
};

double part_of(const Axis& axis, double x) {
  if (!axis.logarithmic) return (x - axis.low) / (axis.high - axis.low);
  return std::log(x / axis.low) / std::log(axis.high / axis.low);
}

double clamped(const Axis& axis, double x) { return std::clamp(x, axis.low, axis.high); }

const char* point_type(Shape shape) {
  switch (shape) {
    case Shape::ring:
      return "6";
    case Shape::square:
      return "5";
    case Shape::diamond:
      return "13";
    case Shape::triangle:
      return "9";
    case Shape::disc:
    case Shape::none:
      break;
  }
  return "7";
}

std::string axis_commands(const Axis& axis, char which) {
  const std::string name(1, which);
  std::string text =
      axis.logarithmic ? "set logscale " + name + "\n" : "unset logscale " + name + "\n";
  text += "set " + name + "range [" + text_of(axis.low) + ":" + text_of(axis.high) + "]\n";
  text += "set " + name + "label " + quoted(axis.label) + "\n";
  const double decades = std::log10(axis.high / axis.low);
  if (!axis.logarithmic)
    return text + "set format " + name + " \"%g\"; set " + name + "tics autofreq; unset m" + name +
           "tics\n";
  // Powers from far below 1 as powers, few of them; else plain numbers.
  const bool far = axis.low < 0.009 || axis.high > 99999;
  text += "set format " + name + (far ? " \"10^{%L}\"" : " \"%g\"") + "\n";
  const int step = decades > 10 ? 4 : decades > 5 ? 2 : 1;
  text += "set " + name + "tics 1e" +
          std::to_string(static_cast<int>(std::floor(std::log10(axis.low) / step)) * step) +
          ", 1e" + std::to_string(step) + "\n";
  return text + (step > 1 || far ? "unset m" + name + "tics\n" : "set m" + name + "tics 10\n");
}

// A panel's numbers as blocks, "$NAME_0" for the first series.
std::string data_blocks(const Panel& panel, const std::string& name) {
  std::string text;
  for (std::size_t s = 0; s < panel.series.size(); ++s) {
    text += "$" + name + "_" + std::to_string(s) + " << EOD\n";
    for (const Mark& mark : panel.series[s].marks) {
      for (const double x : {mark.x, mark.x_high}) text += text_of(clamped(panel.x, x)) + " ";
      for (const double y : {mark.y, mark.y_other}) text += text_of(clamped(panel.y, y)) + " ";
      text += "\n";
    }
    text += "EOD\n";
  }
  if (panel.front.empty()) return text;
  text += "$" + name + "_front << EOD\n";
  text += text_of(clamped(panel.x, panel.front.front().first)) + " " + text_of(panel.y.high) + "\n";
  for (const auto& [x, y] : panel.front)
    text += text_of(clamped(panel.x, x)) + " " + text_of(clamped(panel.y, y)) + "\n";
  text += text_of(panel.x.high) + " " + text_of(clamped(panel.y, panel.front.back().second)) + "\n";
  return text + "EOD\n";
}

std::string plot_command(const Panel& panel, const std::string& name) {
  std::vector<std::string> parts;
  if (!panel.front.empty())
    parts.push_back("$" + name + "_front with steps lw 1.5 lc rgb \"#b8b8b8\" notitle");
  for (std::size_t s = 0; s < panel.series.size(); ++s) {
    const Series& series = panel.series[s];
    const std::string data = "$" + name + "_" + std::to_string(s),
                      colour = " lc rgb \"" + series.colour + "\"";
    parts.push_back(data + " using 1:4:(0):($3-$4) with vectors nohead lw 1" + colour + " notitle");
    parts.push_back(data + " using 1:3:($2-$1):(0) with vectors nohead lw 2.5" + colour +
                    " notitle");
    if (series.joined) parts.push_back(data + " using 1:3 with lines lw 2" + colour + " notitle");
    if (series.shape != Shape::none)
      parts.push_back(data + " using 1:3 with points ps 0.9 pt " + point_type(series.shape) +
                      colour + " notitle");
    if (panel.key && !series.name.empty())
      parts.push_back("NaN with " +
                      std::string(series.shape == Shape::none ? "lines lw 2"
                                                              : std::string("points ps 0.9 pt ") +
                                                                    point_type(series.shape)) +
                      colour + " title " + quoted(series.name));
  }
  std::string text = "plot ";
  for (std::size_t i = 0; i < parts.size(); ++i) text += (i > 0 ? ", \\\n  " : "") + parts[i];
  return text + "\n";
}

std::string label_commands(const Panel& panel, const Frame& frame) {
  std::vector<LabelWanted> wanted;
  std::vector<std::string> colours;
  std::vector<Box> taken;
  const Box& box = frame.box;
  for (const Series& series : panel.series) {
    for (const Mark& mark : series.marks) {
      const auto at = [&](const Axis& axis, double x, double low, double high) {
        return std::lerp(low, high, part_of(axis, clamped(axis, x)));
      };
      const double x = at(panel.x, mark.x, box.left, box.right),
                   y = at(panel.y, mark.y, box.bottom, box.top);
      taken.push_back({x - 4, y - 4, x + 4, y + 4});
      if (!std::isnan(mark.x_high))
        taken.push_back({x, y - 2, at(panel.x, mark.x_high, box.left, box.right), y + 2});
      if (!std::isnan(mark.y_other)) {
        const double other = at(panel.y, mark.y_other, box.bottom, box.top);
        taken.push_back({x - 1, std::min(y, other), x + 1, std::max(y, other)});
      }
      if (mark.label.empty()) continue;
      wanted.push_back({x, y, mark.label});
      colours.push_back(series.colour);
    }
  }
  const auto places = place_labels(wanted, taken, box, kLabelFont);
  std::string text = "do for [i = 1:999] { unset label i }\n";
  for (std::size_t i = 0; i < places.size(); ++i) {
    text += "set label " + std::to_string(i + 1) + " " + quoted(wanted[i].text) + " at " +
            frame.screen(places[i].x, places[i].y) + (places[i].at_left ? " right" : " left") +
            " noenhanced font \"," + text_of(kLabelFont) + "\" tc rgb \"" + colours[i] + "\"\n";
  }
  return text;
}

std::string panel_commands(const Panel& panel, const Frame& frame, const std::string& name) {
  std::string text = frame.margins() + axis_commands(panel.x, 'x') + axis_commands(panel.y, 'y');
  text += "set title " + quoted(panel.title) + " noenhanced offset 0,-0.6\n";
  text += panel.key ? "set key top right samplen 1 spacing 1.1\n" : "unset key\n";
  return text + label_commands(panel, frame) + plot_command(panel, name);
}

struct Size {
  int width, height;
};

Size size_of(const Figure& figure) {
  const auto count = static_cast<int>(figure.panels.size());
  const int rows = (count + figure.columns - 1) / figure.columns;
  return {figure.columns * figure.panel_width,
          rows * figure.panel_height + static_cast<int>(kCaption)};
}

std::string all_panels(const Figure& figure) {
  const double width = size_of(figure).width, height = size_of(figure).height;
  std::string text = "set multiplot\n";
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const auto columns = static_cast<std::size_t>(figure.columns);
    const double left = static_cast<double>(i % columns) * figure.panel_width;
    const double top = height - kCaption - static_cast<double>(i / columns) * figure.panel_height;
    const Frame frame{{left + kLeft, top - figure.panel_height + kBottom,
                       left + figure.panel_width - kRight, top - kTop},
                      width,
                      height};
    text += panel_commands(figure.panels[i], frame, "p" + std::to_string(i));
  }
  return text + "unset multiplot\nunset output\n";
}

std::string terminal(const std::string& kind, const Size& size, int scale,
                     const std::string& file) {
  return "set terminal " + kind + " size " + std::to_string(scale * size.width) + "," +
         std::to_string(scale * size.height) + " font \"DejaVu Sans," + text_of(kFont) +
         "\" background \"#ffffff\"" +
         (scale > 1 ? " fontscale " + std::to_string(scale) + " linewidth " +
                          std::to_string(scale) + " pointscale " + std::to_string(scale)
                    : "") +
         "\nset output \"" + file + "\"\n";
}

}  // namespace

std::string figure_script(const Figure& figure) {
  const Size size = size_of(figure);
  std::string text =
      "# gnuplot draws " + figure.name + ".svg and " + figure.name + ".png from this.\n";
  for (std::size_t i = 0; i < figure.panels.size(); ++i)
    text += data_blocks(figure.panels[i], "p" + std::to_string(i));
  text += "set encoding utf8; set border 3 lc rgb \"#888888\"\nset tics nomirror textcolor rgb \"" +
          std::string(kInk) + "\"; set grid lc rgb \"#e6e6e6\" lw 0.5\nset label 1000 " +
          quoted(figure.caption) + " at screen " + text_of(14.0 / size.width) + ", screen " +
          text_of(1 - 15.0 / size.height) + " left noenhanced font \"," + text_of(kFont + 1) +
          "\"\n";
  const std::string panels = all_panels(figure);
  return text + terminal("svg", size, 1, figure.name + ".svg") + panels +
         terminal("pngcairo", size, 2, figure.name + ".png") + panels;
}

std::pair<double, double> log_range(const std::vector<double>& numbers, double room) {
  double low = 1e300, high = 0;
  for (const double x : numbers) {
    if (!(x > 0) || std::isinf(x)) continue;
    low = std::min(low, x), high = std::max(high, x);
  }
  if (!(high > 0)) return {1, 10};
  low /= room, high *= room;
  const auto rounded = [](double x, bool up) {
    const double power = std::pow(10, std::floor(std::log10(x)));
    double best = up ? 10 * power : power;
    for (const double step : {2.0, 5.0}) {
      if (up && step * power >= x) best = std::min(best, step * power);
      if (!up && step * power <= x) best = std::max(best, step * power);
    }
    return up && power >= x ? power : best;
  };
  return {rounded(low, false), rounded(high, true)};
}

}  // namespace gonio::cli
