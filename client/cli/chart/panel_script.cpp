#include "client/cli/chart/panel_script.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gonio::cli {
namespace {

std::string margins(const Frame& frame) {
  const Box& box = frame.box;
  return "set lmargin at screen " + script_number(box.left / frame.width) +
         "; set rmargin at screen " + script_number(box.right / frame.width) +
         "; set bmargin at screen " + script_number(box.bottom / frame.height) +
         "; set tmargin at screen " + script_number(box.top / frame.height) + "\n";
}

std::string on_screen(const Frame& frame, double x, double y) {
  return "screen " + script_number(x / frame.width) + ", screen " + script_number(y / frame.height);
}

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
  text +=
      "set " + name + "range [" + script_number(axis.low) + ":" + script_number(axis.high) + "]\n";
  const double decades = std::log10(axis.high / axis.low);
  if (!axis.numbered) return text + "set format " + name + " \"\"; unset " + name + "tics\n";
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

// Pixels of a panel's coordinates.
class Pixels {
 public:
  Pixels(const Panel& panel, const Box& box) : panel_(panel), box_(box) {}
  [[nodiscard]] double x(double value) const {
    return std::lerp(box_.left, box_.right, part_of(panel_.x, clamped(panel_.x, value)));
  }
  [[nodiscard]] double y(double value) const {
    return std::lerp(box_.bottom, box_.top, part_of(panel_.y, clamped(panel_.y, value)));
  }

 private:
  const Panel& panel_;
  const Box& box_;
};

// What labels must not stand on: a mark with its bar and line.
void take_mark(const Mark& mark, const Pixels& at, std::vector<Box>& taken) {
  const double x = at.x(mark.x), y = at.y(mark.y);
  taken.push_back({x - 5, y - 5, x + 5, y + 5});
  if (!std::isnan(mark.x_high)) {
    const double other = at.x(mark.x_high);
    taken.push_back({std::min(x, other), y - 2, std::max(x, other), y + 2});
  }
  if (std::isnan(mark.y_other)) return;
  const double other = at.y(mark.y_other);
  taken.push_back({x - 1, std::min(y, other), x + 1, std::max(y, other)});
}

// A front's steps.
void take_front(const Front& front, const Pixels& at, double right, std::vector<Box>& taken) {
  for (std::size_t i = 0; i < front.size(); ++i) {
    const bool last = i + 1 == front.size();
    const double y = at.y(front[i].second), to = last ? right : at.x(front[i + 1].first);
    taken.push_back({at.x(front[i].first), y - 2, to, y + 2});
    if (!last) taken.push_back({to - 2, at.y(front[i + 1].second), to + 2, y});
  }
}

// The line through a series, as a row of boxes.
void take_line(const Series& series, const Pixels& at, std::vector<Box>& taken) {
  constexpr int kSteps = 24;
  for (std::size_t i = 1; i < series.marks.size(); ++i) {
    const Mark &a = series.marks[i - 1], &b = series.marks[i];
    const double ax = at.x(a.x), bx = at.x(b.x), ay = at.y(a.y), by = at.y(b.y);
    const int steps = std::clamp(static_cast<int>(std::hypot(bx - ax, by - ay) / 6), 1, kSteps);
    for (int k = 0; k < steps; ++k) {
      const double x = std::lerp(ax, bx, (k + 0.5) / steps),
                   y = std::lerp(ay, by, (k + 0.5) / steps);
      taken.push_back({x - 3, y - 3, x + 3, y + 3});
    }
  }
}

constexpr double kFar = 18;  // a label so far from its mark has a line to it

std::string label_commands(const Panel& panel, const Frame& frame) {
  std::vector<LabelWanted> wanted;
  std::vector<std::string> colours;
  std::vector<Box> taken;
  const Pixels at(panel, frame.box);
  for (const Series& series : panel.series) {
    if (series.joined) take_line(series, at, taken);
    for (const Mark& mark : series.marks) {
      take_mark(mark, at, taken);
      if (mark.label.empty()) continue;
      wanted.push_back({at.x(mark.x), at.y(mark.y), mark.label});
      colours.push_back(series.colour);
    }
  }
  for (const Front& front : panel.fronts) take_front(front, at, frame.box.right, taken);
  const auto places = place_labels(wanted, taken, frame.box, kLabelFont);
  std::string text = "do for [i = 1:999] { unset label i }\nunset arrow\n";
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (std::hypot(places[i].x - wanted[i].x, places[i].y - wanted[i].y) > kFar) {
      text += "set arrow from " + on_screen(frame, wanted[i].x, wanted[i].y) + " to " +
              on_screen(frame, places[i].x, places[i].y) + " nohead lw 0.5 lc rgb \"" + colours[i] +
              "\"\n";
    }
    text += "set label " + std::to_string(i + 1) + " " + script_text(wanted[i].text) + " at " +
            on_screen(frame, places[i].x, places[i].y) + (places[i].at_left ? " right" : " left") +
            " noenhanced font \"," + script_number(kLabelFont) + "\" tc rgb \"" + colours[i] +
            "\"\n";
  }
  return text;
}

// Gnuplot's own would stand at a distance that depends on the tics' width.
std::string axis_labels(const Panel& panel, const Frame& frame) {
  const Box& box = frame.box;
  std::string text = "unset label 1001; unset label 1002\n";
  if (frame.x_label) {
    text += "set label 1001 " + script_text(panel.x.label) + " at " +
            on_screen(frame, (box.left + box.right) / 2, box.bottom - 34) + " center\n";
  }
  if (frame.y_label) {
    text += "set label 1002 " + script_text(panel.y.label) + " at " +
            on_screen(frame, box.left - 62, (box.bottom + box.top) / 2) + " center rotate by 90\n";
  }
  return text;
}

std::string plot_command(const Panel& panel, const std::string& name) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < panel.fronts.size(); ++i) {
    if (!panel.fronts[i].empty())
      parts.push_back("$" + name + "_front" + std::to_string(i) +
                      " with steps lw 1.5 lc rgb \"#b8b8b8\" notitle");
  }
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
                      colour + " title " + script_text(series.name));
  }
  std::string text = "plot ";
  for (std::size_t i = 0; i < parts.size(); ++i) text += (i > 0 ? ", \\\n  " : "") + parts[i];
  return text + "\n";
}

}  // namespace

std::string script_number(double x) {
  char text[32];
  std::snprintf(text, sizeof(text), std::isnan(x) ? "NaN" : "%.7g", x);
  return text;
}

// In single quotes, in which gnuplot runs nothing: between double ones it would take `date` for a
// command. A name may come from a file or a server.
std::string script_text(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    const bool control = static_cast<unsigned char>(c) < ' ';
    out += control ? ' ' : c;
    if (c == '\'') out += c;
  }
  return out + "'";
}

// A panel's numbers as blocks, "$NAME_0" for the first series.
std::string data_blocks(const Panel& panel, const std::string& name) {
  std::string text;
  for (std::size_t s = 0; s < panel.series.size(); ++s) {
    text += "$" + name + "_" + std::to_string(s) + " << EOD\n";
    for (const Mark& mark : panel.series[s].marks) {
      for (const double x : {mark.x, mark.x_high}) text += script_number(clamped(panel.x, x)) + " ";
      for (const double y : {mark.y, mark.y_other})
        text += script_number(clamped(panel.y, y)) + " ";
      text += "\n";
    }
    text += "EOD\n";
  }
  for (std::size_t i = 0; i < panel.fronts.size(); ++i) {
    const Front& front = panel.fronts[i];
    if (front.empty()) continue;
    text += "$" + name + "_front" + std::to_string(i) + " << EOD\n";
    text += script_number(clamped(panel.x, front.front().first)) + " " +
            script_number(panel.y.high) + "\n";
    for (const auto& [x, y] : front) {
      text += script_number(clamped(panel.x, x)) + " " + script_number(clamped(panel.y, y)) + "\n";
    }
    text += script_number(panel.x.high) + " " +
            script_number(clamped(panel.y, front.back().second)) + "\nEOD\n";
  }
  return text;
}

std::string panel_commands(const Panel& panel, const Frame& frame, const std::string& name) {
  std::string text = margins(frame) + axis_commands(panel.x, 'x') + axis_commands(panel.y, 'y');
  text += "set title " + script_text(panel.title) + " noenhanced offset 0,-0.6\n";
  text += panel.key ? "set key top right samplen 1 spacing 1.1\n" : "unset key\n";
  if (panel.only_key)
    text +=
        "set key center center samplen 1 spacing 1.3; unset border; unset tics; "
        "unset grid\n";
  return text + label_commands(panel, frame) + axis_labels(panel, frame) +
         plot_command(panel, name);
}

}  // namespace gonio::cli
