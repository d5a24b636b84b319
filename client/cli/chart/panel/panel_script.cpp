#include "client/cli/chart/panel/panel_script.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "client/cli/chart/panel/panel_geometry.h"

namespace gonio::cli {
namespace {

std::string margins(const Frame& frame) {
  const Box& box = frame.box;
  return "set lmargin at screen " + script_number(box.left / frame.width) +
         "; set rmargin at screen " + script_number(box.right / frame.width) +
         "; set bmargin at screen " + script_number(box.bottom / frame.height) +
         "; set tmargin at screen " + script_number(box.top / frame.height) + "\n";
}

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
