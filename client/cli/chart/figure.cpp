#include "client/cli/chart/figure.h"

#include <algorithm>
#include <cmath>

#include "client/cli/chart/panel/panel_script.h"

namespace gonio::cli {
namespace {

constexpr double kLeft = 78, kRight = 22, kTop = 26, kBottom = 46;  // around a panel's plot
constexpr double kCaption = 30;
constexpr double kFont = 11;
const std::string kLook =
    "set border 3 lc rgb \"#888888\"; set xtics nomirror tc rgb \"#222222\"; set ytics nomirror tc "
    "rgb \"#222222\"\n"
    "set grid lc rgb \"#e6e6e6\" lw 0.5\n";

struct Size {
  int width, height;
};

Size size_of(const Figure& figure) {
  const auto count = static_cast<int>(figure.panels.size());
  const int rows = (count + figure.columns - 1) / figure.columns;
  return {figure.columns * figure.panel_width,
          rows * figure.panel_height + static_cast<int>(kCaption)};
}

// Axes that say what those beside them say are not labelled again.
bool is_same(const Figure& figure, std::size_t i, std::size_t other, Axis Panel::*axis) {
  return other < figure.panels.size() && !figure.panels[other].only_key &&
         (figure.panels[i].*axis).label == (figure.panels[other].*axis).label;
}

Frame frame_of(const Figure& figure, std::size_t i) {
  const auto [width, height] = size_of(figure);
  const auto columns = static_cast<std::size_t>(figure.columns);
  const std::size_t column = i % columns, row = i / columns;
  const double left = static_cast<double>(column) * figure.panel_width;
  const double top = height - kCaption - static_cast<double>(row) * figure.panel_height;
  return {{left + kLeft, top - figure.panel_height + kBottom, left + figure.panel_width - kRight,
           top - kTop},
          static_cast<double>(width),
          static_cast<double>(height),
          !is_same(figure, i, i + columns, &Panel::x),
          column == 0 || !is_same(figure, i, i - 1, &Panel::y)};
}

// A name in it may be long.
std::string shortened(const std::string& text, double width) {
  const auto most = static_cast<std::size_t>(width / (0.62 * (kFont + 1)));
  return text.size() <= most ? text : text.substr(0, most - 3) + "...";
}

std::string all_panels(const Figure& figure) {
  const Size size = size_of(figure);
  std::string text = "set multiplot\nset label 1000 " +
                     script_text(shortened(figure.caption, size.width - 28.0)) + " at screen " +
                     script_number(14.0 / size.width) + ", screen " +
                     script_number(1 - 15.0 / size.height) + " left noenhanced font \"," +
                     script_number(kFont + 1) + "\"\n";
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    text += kLook + panel_commands(figure.panels[i], frame_of(figure, i), "p" + std::to_string(i)) +
            "unset label 1000\n";
  }
  return text + "unset multiplot\nunset output\n";
}

std::string terminal(const std::string& kind, const Size& size, int scale,
                     const std::string& file) {
  return "set terminal " + kind + " size " + std::to_string(scale * size.width) + "," +
         std::to_string(scale * size.height) + " font \"DejaVu Sans," + script_number(kFont) +
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
  text += "set encoding utf8\n";
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
